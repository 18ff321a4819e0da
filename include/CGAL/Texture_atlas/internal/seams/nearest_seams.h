// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shortest paths from the nearest border or seam to all nodes of an opened surface, which are kept up to date while
// seams change. `greedy_cones.h` adds seams to terminals along them, `shorten_paths.h` exchanges seams by them.
//
// A tree that finds the triangle or segment nearest to a point. `symmetry_impl.h`, `seam_router.h` and `mirror_seams.h`
// search in it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_NEAREST_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_NEAREST_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>

#include <CGAL/AABB_tree.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#if __has_include(<CGAL/AABB_traits_3.h>) // CGAL 6
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// `Object` is a triangle or a segment. There is at least one, and none is degenerate.
template <typename Object>
class Nearest_objects
{
  typedef typename std::vector<Object>::const_iterator Iterator;
  static constexpr bool are_triangles = std::is_same<Object, Seam_kernel::Triangle_3>::value;
#if __has_include(<CGAL/AABB_traits_3.h>)
  typedef std::conditional_t<are_triangles, CGAL::AABB_triangle_primitive_3<Seam_kernel, Iterator>,
                             CGAL::AABB_segment_primitive_3<Seam_kernel, Iterator>>
      Primitive;
  typedef CGAL::AABB_traits_3<Seam_kernel, Primitive> Traits;
#else
  typedef std::conditional_t<are_triangles, CGAL::AABB_triangle_primitive<Seam_kernel, Iterator>,
                             CGAL::AABB_segment_primitive<Seam_kernel, Iterator>>
      Primitive;
  typedef CGAL::AABB_traits<Seam_kernel, Primitive> Traits;
#endif

public:
  explicit Nearest_objects(std::vector<Object> objects)
      : m_objects(std::move(objects)), m_tree(m_objects.cbegin(), m_objects.cend())
  {
    m_tree.build();
  }

  Seam_kernel::Point_3 point(const Seam_kernel::Point_3& p) const
  {
    return m_tree.closest_point(p);
  }

  double squared_distance(const Seam_kernel::Point_3& p) const
  {
    return m_tree.squared_distance(p);
  }

  std::size_t object(const Seam_kernel::Point_3& p) const
  {
    return static_cast<std::size_t>(m_tree.closest_point_and_primitive(p).second - m_objects.cbegin());
  }

private:
  const std::vector<Object> m_objects;
  CGAL::AABB_tree<Traits> m_tree;
};

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

  // Of each node: the corner to the left of the first edge of its path, at the source; any corner of a source. Nodes
  // are numbered again when seams change, corners are not.
  std::vector<int> m_first_corner;
  std::int64_t m_visits = 0;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_NEAREST_SEAMS_H
