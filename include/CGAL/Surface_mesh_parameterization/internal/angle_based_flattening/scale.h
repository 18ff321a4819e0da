// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SCALE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>

#include <CGAL/bounding_box.h>

#include <cmath>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

inline double surface_area(const Chart& chart, int t)
{
  return std::sqrt(CGAL::squared_area(chart.points[chart.vertex[3 * t]],
                                      chart.points[chart.vertex[3 * t + 1]],
                                      chart.points[chart.vertex[3 * t + 2]]));
}

// Positive for triangles that are not flipped.
inline double planar_area(const Chart& chart, const std::vector<Chart::Point_2>& uv, int t)
{
  return CGAL::area(uv[chart.vertex[3 * t]], uv[chart.vertex[3 * t + 1]], uv[chart.vertex[3 * t + 2]]);
}

// Scales the planar chart to the area of the surface, and moves its lower left corner to the origin.
inline void scale_to_surface_area(const Chart& chart, std::vector<Chart::Point_2>& uv)
{
  double surface = 0, plane = 0;
  for(int t = 0; t < chart.number_of_triangles(); ++t) {
    surface += surface_area(chart, t);
    plane += std::abs(planar_area(chart, uv, t));
  }
  const double factor = std::sqrt(surface / plane);
  const auto corner = (CGAL::bounding_box(uv.begin(), uv.end()).min)();
  for(Chart::Point_2& p : uv)
    p = CGAL::ORIGIN + (p - corner) * factor;
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SCALE_H
