// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PLANAR_ANGLE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PLANAR_ANGLE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/target_angles.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The angle at corner `c` in the plane, regardless of orientation.
inline double planar_angle(const Chart& chart, const std::vector<Chart::Point_2>& uv, int c)
{
  const Chart::Point_2& p = uv[chart.vertex[c]];
  const auto a = uv[chart.vertex[next_corner(c)]] - p;
  const auto b = uv[chart.vertex[previous_corner(c)]] - p;
  return std::atan2(std::abs(CGAL::determinant(a, b)), a * b);
}

inline double smallest_angle(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  double smallest = pi;
  for(int c = 0; c < chart.number_of_corners(); ++c)
    smallest = (std::min)(smallest, planar_angle(chart, uv, c));
  return smallest;
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PLANAR_ANGLE_H
