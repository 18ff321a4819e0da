// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MEASURES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MEASURES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/scale.h>
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

// Mean over the corners of triangle `t` of the energy of Eq. 1.
inline double angular_distortion(const Chart& chart, const std::vector<double>& beta,
                                 const std::vector<Chart::Point_2>& uv, int t)
{
  double sum = 0;
  for(int c = 3 * t; c < 3 * t + 3; ++c)
    sum += Angle_energy{0}.value(planar_angle(chart, uv, c), beta[c]);
  return sum / 3;
}

// The derivatives of the map from the plane to the surface on triangle `t`.
struct Surface_derivatives
{
  Surface_derivatives(const Chart& chart, const std::vector<Chart::Point_2>& uv, int t)
      : u(0, 0, 0), v(0, 0, 0)
  {
    const double twice_area = 2 * planar_area(chart, uv, t);
    for(int c = 3 * t; c < 3 * t + 3; ++c) {
      const auto facing_edge = uv[chart.edge_target(c)] - uv[chart.edge_source(c)];
      const auto p = chart.points[chart.vertex[c]] - chart.points[chart.vertex[3 * t]];
      u = u - p * (facing_edge.y() / twice_area);
      v = v + p * (facing_edge.x() / twice_area);
    }
  }

  Chart::Kernel::Vector_3 u, v;
};

// The L2 stretch of Sander et al. (2001) and the L2 shear of Eq. 24, over all triangles. The stretch is that of
// a map whose planar and surface areas are equal.
struct Stretch_and_shear
{
  double l2_stretch, l2_shear;
};

inline Stretch_and_shear stretch_and_shear(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  double surface = 0, plane = 0, stretch = 0, shear = 0;
  for(int t = 0; t < chart.number_of_triangles(); ++t) {
    const Surface_derivatives d(chart, uv, t);
    const double area = surface_area(chart, t);
    const double cosine_squared = CGAL::square(d.u * d.v) / (d.u.squared_length() * d.v.squared_length());
    surface += area;
    plane += std::abs(planar_area(chart, uv, t));
    stretch += area * (d.u.squared_length() + d.v.squared_length()) / 2;
    if(area > 0)
      shear += area * cosine_squared;
  }
  return {std::sqrt(stretch / surface * (plane / surface)), std::sqrt(shear / surface)};
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MEASURES_H
