// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The numbers of type `float` that coordinates in files are rounded to. `polygons/round_to_floats.h` and
// `polygons/make_polygons_convex.h` move vertices to them.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_FLOAT_GRID_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_FLOAT_GRID_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Rounds by arithmetic: GCC 12 removes conversions to `float` and back where it vectorizes.
struct Float_grid
{
  // Whether 1 - x is of type `float` for each number x, because v goes down in glTF. From 0 to 1, these are the
  // multiples of 2^-24.
  bool has_complements = true;

  // The distance of such numbers near this one
  double step(double x) const
  {
    const int digits = std::numeric_limits<float>::digits;
    int exponent = 0;
    const double size = has_complements ? (std::max)(std::abs(x), std::abs(1 - x)) : std::abs(x);
    if(std::frexp(size, &exponent) == 0.5)
      --exponent; // a power of two is a multiple of the smaller distance, too
    const double step =
        std::ldexp(1, (std::max)(exponent, std::numeric_limits<float>::min_exponent) - digits);
    return has_complements && step > 1 ? 2 * step
                                       : step; // 1 - x is no multiple of it, but always rounded alike
  }

  double rounded(double x) const
  {
    const double unit = step(x);
    return std::rint(x / unit) * unit;
  }

  template <typename Point>
  Point rounded_point(const Point& p) const
  {
    return Point(rounded(p.x()), rounded(p.y()));
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_FLOAT_GRID_H
