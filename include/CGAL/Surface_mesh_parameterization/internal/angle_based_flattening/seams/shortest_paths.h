// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Dijkstra's search on an opened surface, which can be bounded, restricted and repeated at the cost of what it visits.
// All seam searches use it: `cut_topology.h`, `greedy_cones.h`, `shorten_paths.h`, `coarse_seams.h` and, in `atlas/`,
// further seams.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SHORTEST_PATHS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SHORTEST_PATHS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/sector_graph.h>

#include <boost/graph/detail/d_ary_heap.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The cost of an edge that must not become a seam
inline constexpr double forbidden = std::numeric_limits<double>::infinity();

// Shortest paths from some nodes of an opened surface. Searches can follow one another, also when seams have changed:
// each takes time for the nodes that it visits and those that the one before visited, not for the whole surface.
class Shortest_paths
{
public:
  // `cost` is that of the edge that each corner faces.
  Shortest_paths(const Sector_graph& surface, const std::vector<double>& cost)
      : m_surface(surface), m_cost(cost), m_labels(surface.number_of_nodes())
  {}

  // Paths lead through these nodes only.
  void restrict_to(std::vector<char> is_allowed) { m_is_allowed = std::move(is_allowed); }

  // Finds the nearest node with `is_target(x)`, at a distance of at most `bound`, or else -1.
  template <typename IsTarget>
  int find(const std::vector<int>& sources, double bound, const IsTarget& is_target)
  {
    forget_last_search();
    Queue queue(Distance_map{&m_labels}, Place_map{&m_labels});
    for(int x : sources)
      reach(x, 0, -1, queue);
    while(!queue.empty()) {
      const int x = queue.top();
      queue.pop();
      ++m_visited;
      if(!is_reached(x) || distance(x) > bound)
        return -1;
      if(is_target(x))
        return x;
      for(auto [edge, end] = out_edges(x, m_surface); edge != end; ++edge)
        reach(m_surface.target_node(*edge), distance(x) + cost(*edge), *edge, queue);
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
  std::vector<int> path(int x) const
  {
    std::vector<int> edges;
    for(int c = last_edge(x); c >= 0; c = last_edge(m_surface.source_node(c)))
      edges.push_back(c);
    return edges;
  }

private:
  // What a search knows of a node, in one place of memory
  struct Label
  {
    double distance = forbidden;
    int last_edge = -1;
    int place = -1; // in the queue, while it is there
  };

  struct Distance_map
  {
    typedef int key_type;
    typedef double value_type, reference;
    typedef boost::readable_property_map_tag category;

    friend double get(const Distance_map& map, int x) { return (*map.labels)[x].distance; }

    const std::vector<Label>* labels;
  };

  struct Place_map
  {
    typedef int key_type, value_type, reference;
    typedef boost::read_write_property_map_tag category;

    friend int get(const Place_map& map, int x) { return (*map.labels)[x].place; }
    friend void put(const Place_map& map, int x, std::size_t place)
    {
      (*map.labels)[x].place = static_cast<int>(place);
    }

    std::vector<Label>* labels;
  };

  typedef boost::d_ary_heap_indirect<int, 4, Place_map, Distance_map, std::less<double>> Queue;

  double cost(int c) const
  {
    return m_is_allowed.empty() || m_is_allowed[m_surface.target_node(c)] ? m_cost[c] : forbidden;
  }

  void forget_last_search()
  {
    for(int x : m_touched)
      m_labels[x] = Label();
    m_touched.clear();
    m_labels.resize(m_surface.number_of_nodes());
    m_visited = 0;
  }

  // Notes a path to a node if it is the shortest so far. Nodes at an infinite distance are queued too: the order of
  // nodes at the same distance depends on all that are in the queue.
  void reach(int x, double distance, int last_edge, Queue& queue)
  {
    Label& label = m_labels[x];
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
  std::vector<char> m_is_allowed; // all of them if empty
  std::vector<Label> m_labels;    // of each node
  std::vector<int> m_touched;     // the nodes with labels other than the first ones
  int m_visited = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SHORTEST_PATHS_H
