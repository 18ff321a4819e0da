// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_DUAL_TREE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_DUAL_TREE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/border_walk.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The next edge of a triangle, counterclockwise, after the one that corner `c` faces
inline Planar_edge next_edge(const Planar_edge& edge, const std::vector<double>& alpha, int c)
{
  return {edge.direction + pi - alpha[previous_corner(c)],
          edge.log_length + std::log(std::sin(alpha[next_corner(c)]) / std::sin(alpha[c]))};
}

// The first edge of each hole, if the first edge of the outer border has direction and log length 0: what the angles say along
// the shortest way from triangle to triangle. (Other ways differ by no more than the angles violate their constraints.)
inline std::vector<Planar_edge> first_edges_of_holes(const Chart& chart, const std::vector<double>& alpha)
{
  std::vector<Planar_edge> edge(chart.vertex.size()); // that each corner faces
  std::vector<int> entry{chart.borders.front().front()};
  std::vector<char> is_found(chart.number_of_triangles(), false);
  is_found[entry.front() / 3] = true;
  for(std::size_t i = 0; i < entry.size(); ++i) {
    for(int c = entry[i]; next_corner(c) != entry[i]; c = next_corner(c))
      edge[next_corner(c)] = next_edge(edge[c], alpha, c);
    for(int c = 3 * (entry[i] / 3), end = c + 3; c < end; ++c)
      if(const int across = chart.opposite[c]; across >= 0 && !is_found[across / 3]) {
        is_found[across / 3] = true;
        edge[across] = {edge[c].direction + pi, edge[c].log_length};
        entry.push_back(across);
      }
  }
  std::vector<Planar_edge> first_edges;
  for(int k = 0; k < chart.number_of_holes(); ++k)
    first_edges.push_back(edge[chart.hole(k).front()]);
  return first_edges;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_DUAL_TREE_H
