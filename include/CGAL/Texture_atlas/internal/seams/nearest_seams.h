// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shortest paths from the nearest border or seam to all nodes of an opened surface, which are kept up to date while
// seams change, and the shortest path across an annulus by them. `find_seams_impl.h` adds seams to terminals along such
// paths, `shorten_paths.h` exchanges seams by them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_NEAREST_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_NEAREST_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The Voronoi diagram of borders and seams: a forest of shortest paths from the nodes there, its sources. When a path
// becomes seams, or no longer is, only the nodes are visited that are nearest to it.
class Nearest_seams
{
public:
  // `cost` is that of the edge that each corner faces.
  Nearest_seams(Sector_graph& surface, const std::vector<double>& cost) : m_surface(surface), m_cost(cost) {}

  Nearest_seams(const Nearest_seams&) = delete; // the queue knows the labels
  Nearest_seams& operator=(const Nearest_seams&) = delete;

  // Finds all paths, as the seams are now.
  void find()
  {
    m_labels.assign(m_surface.number_of_nodes(), Path_label());
    m_first_corner.assign(m_surface.number_of_nodes(), -1);
    for(int x = 0; x < m_surface.number_of_nodes(); ++x)
      if(m_surface.is_node(x) && m_surface.is_on_border(x)) {
        make_source(x);
        m_queue.push(x);
      }
    spread();
  }

  bool is_reached(int x) const { return m_labels[x].distance < forbidden; }
  double distance(int x) const { return m_labels[x].distance; }
  int last_edge(int x) const { return m_labels[x].last_edge; } // of the path, or -1 at a source

  // The source of the path to a node that is reached
  int source(int x) const { return m_surface.node(m_first_corner[x]); }

  // The edges of the path to a node, the last one first
  std::vector<int> path(int x) const { return path_to(x, m_labels, m_surface); }

  std::int64_t number_of_visits() const { return m_visits; }

  // Makes seams of the edges of a path between sources, or from a source to any other node.
  void open(const std::vector<int>& path)
  {
    std::vector<int> added; // corners at the nodes that become sources
    for(int c : path)
      for(int end : {next_corner(c), previous_corner(c)})
        if(const int x = m_surface.node(end); !is_reached(x) || last_edge(x) >= 0)
          added.push_back(end);
    for(int c : path)
      m_surface.set_seam(c, true);
    resize();
    make_sources_around(path);
    for(int end : added)
      for_corners_around(chart(), end, [&](int c) {
        if(const int x = m_surface.node(c); m_labels[x].place < 0)
          m_queue.push(x);
      });
    spread();
  }

  // Makes no seams of the edges of a path, which begins with its first edge, and along which there are no other ones.
  // Its ends remain sources. Only nodes that were nearest to it within `bound` get other paths, and only such as are at
  // most that long, or none; the rest of those that were nearest to it keeps paths that are longer.
  void close(const std::vector<int>& path, double bound = forbidden)
  {
    for(int c : path)
      m_surface.set_seam(c, false);
    resize();
    make_sources_around(path);
    m_lost.clear();
    for(std::size_t i = 1; i < path.size(); ++i) {
      m_lost.push_back(m_surface.source_node(path[i]));
      m_labels[m_lost.back()] = Path_label();
    }
    forget_behind_lost_nodes(bound);
    for(int x : m_lost)
      for(auto [edge, end] = out_edges(x, m_surface); edge != end; ++edge)
        if(const int y = m_surface.target_node(*edge); is_reached(y) && m_labels[y].place < 0)
          reach(x, distance(y) + m_cost[*edge], chart().opposite[*edge], bound);
    spread(bound);
  }

  // Makes seams again of the path that was closed last.
  void reopen(const std::vector<int>& path)
  {
    for(int c : path)
      m_surface.set_seam(c, true);
    resize();
    make_sources_around(path);
    for(const Forgotten& node : m_forgotten) {
      m_labels[node.node] = node.label;
      m_first_corner[node.node] = node.first_corner;
    }
  }

private:
  const Chart& chart() const { return m_surface.surface(); }

  void resize()
  {
    m_labels.resize(m_surface.number_of_nodes());
    m_first_corner.resize(m_surface.number_of_nodes(), -1);
  }

  void make_source(int x)
  {
    m_labels[x] = {0, -1, -1};
    m_first_corner[x] = m_surface.first_corner(x);
  }

  void make_sources_around(const std::vector<int>& path)
  {
    for(int c : path)
      for(int end : {next_corner(c), previous_corner(c)})
        for_corners_around(chart(), end, [&](int corner) { make_source(m_surface.node(corner)); });
  }

  // Forgets all paths through lost nodes, as far as they are not longer than `bound`: their ends are lost, too.
  void forget_behind_lost_nodes(double bound)
  {
    m_forgotten.clear();
    for(std::size_t i = 0; i < m_lost.size(); ++i)
      for(auto [edge, end] = out_edges(m_lost[i], m_surface); edge != end; ++edge)
        if(const int y = m_surface.target_node(*edge); last_edge(y) == *edge && distance(y) <= bound) {
          m_forgotten.push_back({y, m_labels[y], m_first_corner[y]});
          m_labels[y] = Path_label();
          m_lost.push_back(y);
        }
  }

  void spread(double bound = forbidden)
  {
    while(!m_queue.empty()) {
      Deadline::ask();
      const int x = m_queue.top();
      m_queue.pop();
      ++m_visits;
      if(const int c = last_edge(x); c >= 0) {
        const int before = m_surface.source_node(c);
        m_first_corner[x] = last_edge(before) < 0 ? next_corner(c) : m_first_corner[before];
      }
      for(auto [edge, end] = out_edges(x, m_surface); edge != end; ++edge)
        reach(m_surface.target_node(*edge), distance(x) + m_cost[*edge], *edge, bound);
    }
  }

  // Notes a path to a node if it is shorter than the one so far, or the same one with another beginning.
  void reach(int x, double distance, int last_edge, double bound)
  {
    Path_label& label = m_labels[x];
    if(distance > bound || (!(distance < label.distance) && last_edge != label.last_edge))
      return;
    label.distance = distance;
    label.last_edge = last_edge;
    if(label.place >= 0)
      m_queue.update(x);
    else
      m_queue.push(x);
  }

  struct Forgotten
  {
    int node;
    Path_label label;
    int first_corner;
  };

  Sector_graph& m_surface;
  const std::vector<double>& m_cost;
  std::vector<Path_label> m_labels; // of each node
  Path_queue m_queue = path_queue(m_labels);
  std::vector<int> m_lost;            // the nodes whose paths the last closed path has cut
  std::vector<Forgotten> m_forgotten; // the labels of these

  // The corner to the left of the first edge of each node's path, at the source; any corner of a source. Nodes
  // are numbered again when seams change, corners are not.
  std::vector<int> m_first_corner;
  std::int64_t m_visits = 0;
};

// Finds the shortest path between the borders of an annulus. Between the regions that are nearest to one border and to
// the other one, there is one closed line of edges, from triangle to triangle. The shortest path crosses it at the edge
// where the paths from its ends to both borders are shortest, as in Mehlhorn's approximation of a Steiner tree. All its
// nodes are at most half its length away from a border: longer paths need not be known.
class Annulus_crossing
{
public:
  Annulus_crossing(const Sector_graph& surface, const std::vector<double>& cost, const Nearest_seams& nearest)
      : m_surface(surface), m_cost(cost), m_nearest(nearest)
  {}

  // The edges of the shortest path between the borders through two nodes, `from` and `to`; none if it is longer than
  // `bound`, or if the borders are the same. A node that is on no border is one by itself. `path` leads from one node
  // to the other.
  std::vector<int> shortest_path(const std::vector<int>& path, int from, int to, double bound)
  {
    const std::vector<int> border = shorter_border(from, to);
    if(border.empty())
      return {};
    m_is_marked.resize(m_surface.number_of_nodes(), false);
    for(int x : border)
      m_is_marked[x] = true;
    const int bridge = shortest_bridge(first_bridge(path, border.front() == from), bound);
    for(int x : border)
      m_is_marked[x] = false;
    if(bridge < 0)
      return {};
    std::vector<int> result = m_nearest.path(m_surface.source_node(bridge));
    result.push_back(bridge);
    const std::vector<int> rest = m_nearest.path(m_surface.target_node(bridge));
    result.insert(result.end(), rest.begin(), rest.end());
    return result;
  }

private:
  // The nodes of the border through one of two nodes that has fewer edges; none if both are on the same border
  std::vector<int> shorter_border(int x, int y) const
  {
    if(x == y)
      return {};
    std::array<std::vector<int>, 2> nodes = {{{x}, {y}}};
    std::array<int, 2> edge = {edge_before(x), edge_before(y)};
    for(int k = 0;; k = 1 - k) { // along both at the same time
      const int start = nodes[k].front();
      if(!m_surface.is_on_border(start))
        return nodes[k];
      edge[k] = m_surface.next_open(edge[k]);
      if(edge[k] == edge_before(start))
        return nodes[k];
      nodes[k].push_back(m_surface.target_node(edge[k]));
      if(nodes[k].back() == nodes[1 - k].front())
        return {};
    }
  }

  // The border's edge to a node that is on it
  int edge_before(int x) const { return next_corner(m_surface.first_corner(x)); }

  // Whether a node is nearest to the border whose nodes are marked
  bool is_near(int x) const { return m_nearest.is_reached(x) && m_is_marked[m_nearest.source(x)]; }

  // The edge over which a path leaves the region of the marked border, where it begins or ends, for the last time
  int first_bridge(const std::vector<int>& path, bool begins_there) const
  {
    if(begins_there)
      return *std::find_if(path.rbegin(), path.rend(),
                           [&](int c) { return is_near(m_surface.source_node(c)); });
    return *std::find_if(path.begin(), path.end(), [&](int c) { return is_near(m_surface.target_node(c)); });
  }

  // Follows the line of edges between nodes near to the marked border and other nodes. Returns the edge over which the
  // path between both borders is shortest, and at most as long as `bound`, or -1.
  int shortest_bridge(int first, double bound) const
  {
    int bridge = -1;
    double shortest = bound;
    int c = first;
    do {
      const double before = m_nearest.distance(m_surface.source_node(c)),
                   behind = m_nearest.distance(m_surface.target_node(c)),
                   length = before + m_cost[c] + behind;
      if(length < forbidden && before <= bound / 2 && behind <= bound / 2 &&
         (length < shortest || (bridge < 0 && length == shortest))) {
        bridge = c;
        shortest = length;
      }
      const int across = m_surface.surface().opposite[c], next = next_corner(across);
      c = is_near(m_surface.node(across)) == is_near(m_surface.node(next)) ? next : previous_corner(across);
    } while(c != first);
    return bridge;
  }

  const Sector_graph& m_surface;
  const std::vector<double>& m_cost;
  const Nearest_seams& m_nearest;
  std::vector<char> m_is_marked; // of each node
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_NEAREST_SEAMS_H
