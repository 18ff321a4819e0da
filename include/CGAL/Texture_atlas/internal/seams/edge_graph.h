// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The edges of a mesh as a graph, for what follows seams: `seam_router.h`, `symmetry.h` and `join_small_regions.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_EDGE_GRAPH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_EDGE_GRAPH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The edges of a mesh, by the numbers of their ends, with the edges at each vertex
class Edge_graph
{
public:
  typedef std::array<std::size_t, 2> Ends;

  Edge_graph(const std::vector<Seam_kernel::Point_3>& vertex_points, std::vector<Ends> edge_ends)
      : points(vertex_points), ends(std::move(edge_ends)), m_first(points.size() + 1, 0),
        m_edges(2 * ends.size())
  {
    for(const Ends& e : ends)
      for(std::size_t v : e)
        ++m_first[v + 1];
    for(std::size_t v = 0; v < points.size(); ++v)
      m_first[v + 1] += m_first[v];
    std::vector<std::size_t> place(m_first.begin(), m_first.end() - 1);
    for(std::size_t e = 0; e < ends.size(); ++e)
      for(std::size_t v : ends[e])
        m_edges[place[v]++] = e;
  }

  std::size_t other_end(std::size_t e, std::size_t v) const
  {
    return ends[e][0] == v ? ends[e][1] : ends[e][0];
  }

  // Of two vertices that an edge joins
  std::size_t edge_between(std::size_t v, std::size_t w) const
  {
    std::size_t result = 0;
    for_edges_at(v, [&](std::size_t e) { result = other_end(e, v) == w ? e : result; });
    return result;
  }

  double length(std::size_t e) const
  {
    return std::sqrt(CGAL::squared_distance(points[ends[e][0]], points[ends[e][1]]));
  }

  template <typename Function>
  void for_edges_at(std::size_t v, const Function& f) const
  {
    for(std::size_t i = m_first[v]; i < m_first[v + 1]; ++i)
      f(m_edges[i]);
  }

  const std::vector<Seam_kernel::Point_3>& points;
  const std::vector<Ends> ends; // of each edge

private:
  std::vector<std::size_t> m_first; // place of each vertex in `m_edges`
  std::vector<std::size_t> m_edges;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_EDGE_GRAPH_H
