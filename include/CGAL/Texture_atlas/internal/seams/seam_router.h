// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Paths along edges of a mesh that stay near a given line. `mirror_seams.h` draws the mirror images of seams with them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SEAM_ROUTER_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SEAM_ROUTER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_objects.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Finds paths between vertices that are short and stay near a line in space: an edge at a distance d from the line
// costs 1 + (d / width)^2 times its length.
class Seam_router
{
public:
  typedef std::vector<Seam_kernel::Point_3> Line;

  explicit Seam_router(const Edge_graph& graph)
      : m_graph(graph), m_cost(graph.points.size()), m_factor(graph.points.size()),
        m_edge(graph.points.size()), m_search(graph.points.size(), 0)
  {}

  // The edges of a path through vertices with `is_allowed_vertex(v)` and edges with `is_allowed_edge(e)`; empty if
  // there is none
  template <typename Is_allowed_vertex, typename Is_allowed_edge>
  std::vector<std::size_t> path(std::size_t from, std::size_t to, const Line& line, double width,
                                const Is_allowed_vertex& is_allowed_vertex,
                                const Is_allowed_edge& is_allowed_edge)
  {
    typedef std::pair<double, std::size_t> Entry; // cost, vertex
    const Distances distances(line, width);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    ++m_number;
    const auto reach = [&](std::size_t v, double cost, std::size_t e) {
      if(m_search[v] != m_number) {
        m_search[v] = m_number;
        m_cost[v] = std::numeric_limits<double>::infinity();
        m_factor[v] = distances.factor(m_graph.points[v]);
      }
      if(cost < m_cost[v]) {
        m_cost[v] = cost;
        m_edge[v] = e;
        queue.emplace(cost, v);
      }
    };
    reach(from, 0, no_edge);
    while(!queue.empty() && queue.top().second != to) {
      Deadline::ask();
      const auto [cost, v] = queue.top();
      queue.pop();
      if(cost > m_cost[v])
        continue;
      m_graph.for_edges_at(v, [&, v = v, cost = cost](std::size_t e) {
        const std::size_t w = m_graph.other_end(e, v);
        if(is_allowed_vertex(w) && is_allowed_edge(e)) {
          if(m_search[w] != m_number)
            reach(w, std::numeric_limits<double>::infinity(), no_edge);
          reach(w, cost + m_graph.length(e) * (m_factor[v] + m_factor[w]) / 2, e);
        }
      });
    }
    return queue.empty() ? std::vector<std::size_t>() : path_to(to, from);
  }

private:
  class Distances
  {
  public:
    Distances(const Line& line, double width) : m_segments(segments(line)), m_width(width) {}

    double factor(const Seam_kernel::Point_3& p) const
    {
      return 1 + m_segments.squared_distance(p) / (m_width * m_width);
    }

  private:
    static std::vector<Seam_kernel::Segment_3> segments(const Line& line)
    {
      std::vector<Seam_kernel::Segment_3> result;
      for(std::size_t i = 0; i + 1 < line.size(); ++i)
        if(line[i] != line[i + 1] || i == 0)
          result.emplace_back(line[i], line[i + 1]);
      return result;
    }

    Nearest_objects<Seam_kernel::Segment_3> m_segments;
    double m_width;
  };

  std::vector<std::size_t> path_to(std::size_t v, std::size_t from) const
  {
    std::vector<std::size_t> result;
    for(; v != from; v = m_graph.other_end(result.back(), v))
      result.push_back(m_edge[v]);
    std::reverse(result.begin(), result.end());
    return result;
  }

  static constexpr std::size_t no_edge = static_cast<std::size_t>(-1);

  const Edge_graph& m_graph;
  std::vector<double> m_cost, m_factor; // of each vertex, in its last search
  std::vector<std::size_t> m_edge;      // before each vertex on its path
  std::vector<int> m_search;            // the number of the last search that reached the vertex
  int m_number = 0;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SEAM_ROUTER_H
