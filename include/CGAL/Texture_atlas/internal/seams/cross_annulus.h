// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The shortest path between the two borders of an annulus, from the regions nearest to each of them. `shorten_paths.h`
// takes one path of a cut away and puts this one in its place.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CROSS_ANNULUS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CROSS_ANNULUS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_seams.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Texture_atlas::internal {

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

  // Of a node on a border: the border's edge to it
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

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CROSS_ANNULUS_H
