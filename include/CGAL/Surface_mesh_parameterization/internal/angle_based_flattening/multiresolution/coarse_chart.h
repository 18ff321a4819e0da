// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What collapses leave of a chart, copied into a chart of its own, so that methods for any chart can flatten it
// (Section 5). `coarsen.h` makes its stages of it, `coarse_to_fine.h` the chart to be solved, and
// `seams/coarse_seams.h` a copy to cut.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSE_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSE_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// What remains of a chart after collapses, as a separate chart, without borders and constraint nodes. Vertices and
// triangles keep their order.
struct Remaining_chart
{
  Chart chart;
  std::vector<int> vertices; // of each vertex of the coarse chart: its number in the fine one

  Remaining_chart(const Edge_collapses& mesh, const std::vector<int>& alive) : vertices(alive)
  {
    const Chart& fine = mesh.chart();
    chart.scale = fine.scale;
    std::vector<int> rank(fine.points.size(), -1);
    chart.points.reserve(alive.size());
    chart.interior.reserve(alive.size());
    for(int v : alive) {
      rank[v] = chart.number_of_vertices();
      chart.points.push_back(fine.points[v]);
      chart.interior.push_back(fine.interior[v] < 0 ? -1 : chart.number_of_interior_vertices++);
    }
    copy_triangles(fine, rank, mesh.remaining_triangles());
  }

private:
  void copy_triangles(const Chart& fine, const std::vector<int>& vertex_rank,
                      const std::vector<int>& triangles)
  {
    std::vector<int> triangle_rank(fine.number_of_triangles(), -1);
    for(std::size_t t = 0; t < triangles.size(); ++t)
      triangle_rank[triangles[t]] = static_cast<int>(t);
    chart.vertex.reserve(3 * triangles.size());
    chart.opposite.reserve(3 * triangles.size());
    for(int t : triangles)
      for(int c = 3 * t; c < 3 * t + 3; ++c) {
        const int across = fine.opposite[c];
        chart.vertex.push_back(vertex_rank[fine.vertex[c]]);
        chart.opposite.push_back(across < 0 ? -1 : 3 * triangle_rank[across / 3] + across % 3);
      }
    if(!fine.weight.empty())
      for(int t : triangles)
        chart.weight.push_back(fine.weight[t]);
  }
};

// The same with borders
struct Coarse_chart : Remaining_chart
{
  // The first border is the one with vertices of `outer_border`, which may be empty if there is only one.
  Coarse_chart(const Edge_collapses& mesh, const std::vector<int>& alive, std::vector<int> outer_border = {})
      : Remaining_chart(mesh, alive)
  {
    std::sort(outer_border.begin(), outer_border.end());
    find_borders(chart, corner_at_border(outer_border));
  }

private:
  // A corner that faces a border edge from one of these vertices, which are sorted, or -1
  int corner_at_border(const std::vector<int>& border) const
  {
    for(int c = 0; c < chart.number_of_corners() && !border.empty(); ++c)
      if(chart.opposite[c] < 0 &&
         std::binary_search(border.begin(), border.end(), vertices[chart.edge_source(c)]))
        return c;
    return -1;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSE_CHART_H
