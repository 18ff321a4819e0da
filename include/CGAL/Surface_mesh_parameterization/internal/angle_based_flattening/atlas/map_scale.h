// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_MAP_SCALE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_MAP_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The stretch of a map that is due to its scale, `Atlas_report::Chart::scale_stretch`; infinite if a triangle loses its area.
// Unlike the L2 stretch, it can be lowered by seams wherever long thin triangles are.
inline double scale_stretch(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  const Total_areas total = total_areas(chart, uv);
  const double sum = parallel_sum(chart.number_of_triangles(), [&](int t) {
    const double area = surface_area(chart, t);
    return area > 0 ? area * area / std::abs(planar_area(chart, uv, t)) : 0;
  });
  return total.surface > 0 ? std::sqrt(sum * total.plane) / total.surface : 1;
}

// The scale of a map around a vertex
struct Vertex_scale
{
  double area = 0;      // of the triangles around it, on the surface
  double log_scale = 0; // logarithm of the factor of lengths, relative to the mean

  // How much less the stretch would be at this vertex without it. It is large where large triangles hide a moderate scale.
  double stretch_by_area() const { return area * (std::cosh(2 * log_scale) - 1); }
};

// Of each vertex of the surface that was cut open to the chart; `origin` tells whose copies those of the chart are.
inline std::vector<Vertex_scale> vertex_scales(const Chart& chart, const std::vector<Chart::Point_2>& uv,
                                               const std::vector<int>& origin, int number_of_vertices)
{
  std::vector<Vertex_scale> scales(number_of_vertices);
  std::vector<double> plane(number_of_vertices, 0.);
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    for(int k = 0; k < 3; ++k) {
      const int v = origin[chart.vertex[3 * t + k]];
      scales[v].area += surface_area(chart, t);
      plane[v] += std::abs(planar_area(chart, uv, t));
    }
  double mean = 0, total = 0;
  for(int v = 0; v < number_of_vertices; ++v)
    if(scales[v].area > 0 && plane[v] > 0) {
      scales[v].log_scale = std::log(plane[v] / scales[v].area) / 2;
      mean += scales[v].area * scales[v].log_scale;
      total += scales[v].area;
    }
  for(int v = 0; v < number_of_vertices; ++v)
    if(scales[v].area > 0 && plane[v] > 0)
      scales[v].log_scale -= mean / total;
  return scales;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_MAP_SCALE_H
