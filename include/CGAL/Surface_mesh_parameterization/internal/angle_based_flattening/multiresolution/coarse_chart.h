// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSE_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSE_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>

#include <algorithm>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// What remains of a chart after collapses, as a separate chart.
struct Coarse_chart
{
  Chart chart;
  std::vector<int> vertices; // of each vertex of the coarse chart: its number in the fine one

  // The first border is the one with vertices of `outer_border`, which is sorted, and may be empty if there is only one.
  Coarse_chart(const Edge_collapses& mesh, const std::vector<int>& alive,
               const std::vector<int>& outer_border = {})
      : vertices(alive)
  {
    const Chart& fine = mesh.chart();
    chart.scale = fine.scale;
    std::vector<int> rank(fine.points.size(), -1);
    for(int v : alive) {
      rank[v] = chart.number_of_vertices();
      chart.points.push_back(fine.points[v]);
    }
    const std::vector<int> triangles = triangles_of(mesh, alive);
    std::vector<int> triangle_rank(fine.number_of_triangles(), -1);
    for(std::size_t t = 0; t < triangles.size(); ++t)
      triangle_rank[triangles[t]] = static_cast<int>(t);
    for(int t : triangles)
      for(int c = 3 * t; c < 3 * t + 3; ++c) {
        const int across = fine.opposite[c];
        chart.vertex.push_back(rank[fine.vertex[c]]);
        chart.opposite.push_back(across < 0 ? -1 : 3 * triangle_rank[across / 3] + across % 3);
      }
    find_borders(chart, corner_at_border(outer_border));
  }

private:
  // A corner that faces a border edge from one of these vertices, or -1
  int corner_at_border(const std::vector<int>& border) const
  {
    for(int c = 0; c < chart.number_of_corners() && !border.empty(); ++c)
      if(chart.opposite[c] < 0 &&
         std::binary_search(border.begin(), border.end(), vertices[chart.edge_source(c)]))
        return c;
    return -1;
  }

  static std::vector<int> triangles_of(const Edge_collapses& mesh, const std::vector<int>& alive)
  {
    std::vector<char> is_there(mesh.chart().number_of_triangles(), false);
    for(int v : alive)
      mesh.for_each_corner(v, [&](int c) { is_there[c / 3] = true; });
    std::vector<int> triangles;
    for(std::size_t t = 0; t < is_there.size(); ++t)
      if(is_there[t])
        triangles.push_back(static_cast<int>(t));
    return triangles;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSE_CHART_H
