// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSE_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSE_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// What remains of a chart after collapses, as a separate chart.
struct Coarse_chart
{
  Chart chart;
  std::vector<int> vertices; // of each vertex of the coarse chart: its number in the fine one

  Coarse_chart(const Edge_collapses& mesh, const std::vector<int>& alive) : vertices(alive)
  {
    const Chart& fine = mesh.chart();
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
    find_borders(chart);
  }

private:
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
