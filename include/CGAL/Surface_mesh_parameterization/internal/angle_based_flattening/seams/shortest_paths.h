// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SHORTEST_PATHS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SHORTEST_PATHS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/sector_graph.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The cost of an edge that must not become a seam
inline constexpr double forbidden = std::numeric_limits<double>::infinity();

// Shortest paths from some nodes of an opened surface
class Shortest_paths
{
public:
  // `cost` is that of the edge that each corner faces.
  Shortest_paths(const Sector_graph& surface, const std::vector<double>& cost)
      : m_surface(surface), m_cost(cost), m_distance(surface.number_of_nodes(), forbidden),
        m_edge(surface.number_of_nodes(), -1)
  {}

  // Paths lead through these nodes only.
  void restrict_to(std::vector<char> is_allowed) { m_is_allowed = std::move(is_allowed); }

  // Finds the nearest node with `is_target(x)`, at a distance of at most `bound`, or else -1.
  template <typename IsTarget>
  int find(const std::vector<int>& sources, double bound, const IsTarget& is_target)
  {
    for(int x : sources)
      m_distance[x] = 0;
    std::vector<boost::default_color_type> color(m_distance.size(), boost::white_color);
    const boost::typed_identity_property_map<int> index;
    try {
      boost::dijkstra_shortest_paths_no_init(
          m_surface, sources.begin(), sources.end(), boost::dummy_property_map(),
          boost::make_iterator_property_map(m_distance.begin(), index),
          boost::make_function_property_map<int>([&](int c) { return cost(c); }), index, std::less<double>(),
          boost::closed_plus<double>(), 0., Visitor<IsTarget>(*this, bound, is_target),
          boost::make_iterator_property_map(color.begin(), index));
    } catch(const Found& found) {
      return found.node;
    }
    return -1;
  }

  // All of them
  void find_all(const std::vector<int>& sources)
  {
    find(sources, forbidden, [](int) { return false; });
  }

  bool is_reached(int x) const { return m_distance[x] < forbidden; }
  double distance(int x) const { return m_distance[x]; }
  int last_edge(int x) const { return m_edge[x]; } // of the path, or -1 at a source
  int number_of_visited_nodes() const { return m_visited; }

  bool path_has_two_edges(int x) const
  {
    return m_edge[x] >= 0 && m_edge[m_surface.source_node(m_edge[x])] >= 0;
  }

  // The edges of the path to a node, the last one first
  std::vector<int> path(int x) const
  {
    std::vector<int> edges;
    for(int c = m_edge[x]; c >= 0; c = m_edge[m_surface.source_node(c)])
      edges.push_back(c);
    return edges;
  }

private:
  double cost(int c) const
  {
    return m_is_allowed.empty() || m_is_allowed[m_surface.target_node(c)] ? m_cost[c] : forbidden;
  }

  struct Found // ends a search
  {
    int node;
  };

  template <typename IsTarget>
  class Visitor : public boost::dijkstra_visitor<>
  {
  public:
    Visitor(Shortest_paths& paths, double bound, const IsTarget& is_target)
        : m_paths(paths), m_bound(bound), m_is_target(is_target)
    {}

    void examine_vertex(int x, const Sector_graph&) const
    {
      ++m_paths.m_visited;
      if(!(m_paths.m_distance[x] < forbidden) || m_paths.m_distance[x] > m_bound)
        throw Found{-1};
      if(m_is_target(x))
        throw Found{x};
    }

    void edge_relaxed(int c, const Sector_graph& surface) const
    {
      m_paths.m_edge[surface.target_node(c)] = c;
    }

  private:
    Shortest_paths& m_paths;
    double m_bound;
    const IsTarget& m_is_target;
  };

  const Sector_graph& m_surface;
  const std::vector<double>& m_cost;
  std::vector<char> m_is_allowed; // all of them if empty
  std::vector<double> m_distance;
  std::vector<int> m_edge;
  int m_visited = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SHORTEST_PATHS_H
