// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Dijkstra's search on an opened surface, which can be bounded, restricted and repeated at the cost of what it visits.
// All seam searches use it: `cut_topology.h`, `find_seams_impl.h`, `nearest_seams.h`, `shorten_paths.h`,
// `coarse_seams.h` and, in `atlas/`, further seams.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SHORTEST_PATHS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SHORTEST_PATHS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>

#include <boost/graph/detail/d_ary_heap.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The cost of an edge that must not become a seam
inline constexpr double forbidden = std::numeric_limits<double>::infinity();

// What a search knows of a node, in one place of memory
struct Path_label
{
  double distance = forbidden;
  int last_edge = -1; // of the path; -1 at a source
  int place = -1;     // in the queue, while it is there
};

struct Path_distance_map
{
  typedef int key_type;
  typedef double value_type, reference;
  typedef boost::readable_property_map_tag category;

  friend double get(const Path_distance_map& map, int x) { return (*map.labels)[x].distance; }

  const std::vector<Path_label>* labels;
};

struct Path_place_map
{
  typedef int key_type, value_type, reference;
  typedef boost::read_write_property_map_tag category;

  friend int get(const Path_place_map& map, int x) { return (*map.labels)[x].place; }
  friend void put(const Path_place_map& map, int x, std::size_t place)
  {
    (*map.labels)[x].place = static_cast<int>(place);
  }

  std::vector<Path_label>* labels;
};

// The nodes that are reached and not yet visited, the nearest one first
typedef boost::d_ary_heap_indirect<int, 4, Path_place_map, Path_distance_map, std::less<double>> Path_queue;

inline Path_queue path_queue(std::vector<Path_label>& labels)
{
  return Path_queue(Path_distance_map{&labels}, Path_place_map{&labels});
}

// The edges of the path to a node, the last one first
inline std::vector<int> path_to(int x, const std::vector<Path_label>& labels, const Sector_graph& surface)
{
  std::vector<int> edges;
  for(int c = labels[x].last_edge; c >= 0; c = labels[surface.source_node(c)].last_edge)
    edges.push_back(c);
  return edges;
}

// Shortest paths from some nodes of an opened surface. Searches can follow one another, also when seams have changed:
// each takes time for the nodes that it visits and those that the one before visited, not for the whole surface.
class Shortest_paths
{
public:
  // `cost` is that of the edge that each corner faces.
  Shortest_paths(const Sector_graph& surface, const std::vector<double>& cost)
      : m_surface(surface), m_cost(cost), m_labels(surface.number_of_nodes())
  {}

  // Finds the nearest node with `is_target(x)`, at a distance of at most `bound`, or else -1.
  template <typename IsTarget>
  int find(const std::vector<int>& sources, double bound, const IsTarget& is_target)
  {
    return find(sources, bound, is_target, [](int) { return true; });
  }

  // The same along paths through nodes with `is_allowed(x)` only
  template <typename IsTarget, typename IsAllowed>
  int find(const std::vector<int>& sources, double bound, const IsTarget& is_target,
           const IsAllowed& is_allowed)
  {
    forget_last_search();
    Path_queue queue = path_queue(m_labels);
    for(int x : sources)
      reach(x, 0, -1, queue);
    while(!queue.empty()) {
      Deadline::ask();
      const int x = queue.top();
      queue.pop();
      ++m_visited;
      if(!is_reached(x) || distance(x) > bound)
        return -1;
      if(is_target(x))
        return x;
      for(auto [edge, end] = out_edges(x, m_surface); edge != end; ++edge) {
        const int y = m_surface.target_node(*edge);
        reach(y, distance(x) + (is_allowed(y) ? m_cost[*edge] : forbidden), *edge, queue);
      }
    }
    return -1;
  }

  // All of them
  void find_all(const std::vector<int>& sources)
  {
    find(sources, forbidden, [](int) { return false; });
  }

  bool is_reached(int x) const { return m_labels[x].distance < forbidden; }
  double distance(int x) const { return m_labels[x].distance; }
  int last_edge(int x) const { return m_labels[x].last_edge; } // of the path, or -1 at a source
  int number_of_visited_nodes() const { return m_visited; }    // by the last search

  bool path_has_two_edges(int x) const
  {
    return last_edge(x) >= 0 && last_edge(m_surface.source_node(last_edge(x))) >= 0;
  }

  // The edges of the path to a node, the last one first
  std::vector<int> path(int x) const { return path_to(x, m_labels, m_surface); }

private:
  void forget_last_search()
  {
    for(int x : m_touched)
      m_labels[x] = Path_label();
    m_touched.clear();
    m_labels.resize(m_surface.number_of_nodes());
    m_visited = 0;
  }

  // Notes a path to a node if it is the shortest so far. Nodes at an infinite distance are queued too: the order of
  // nodes at the same distance depends on all that are in the queue.
  void reach(int x, double distance, int last_edge, Path_queue& queue)
  {
    Path_label& label = m_labels[x];
    const bool is_new = label.distance == forbidden && label.place < 0;
    if(distance < label.distance) {
      label.distance = distance;
      label.last_edge = last_edge;
      if(label.place >= 0)
        queue.update(x);
    }
    if(is_new) {
      m_touched.push_back(x);
      queue.push(x);
    }
  }

  const Sector_graph& m_surface;
  const std::vector<double>& m_cost;
  std::vector<Path_label> m_labels; // of each node
  std::vector<int> m_touched;       // the nodes with labels other than the first ones
  int m_visited = 0;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SHORTEST_PATHS_H
