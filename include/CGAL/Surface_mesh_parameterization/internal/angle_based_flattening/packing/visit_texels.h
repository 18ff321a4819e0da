// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// All texels that a triangle or segment touches, none missed whatever the rounding. `chart_shape.h` draws with it,
// `certify_packing_impl.h` relies on its bounds, and `baking/chart_texels.h` finds what to bake by it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_VISIT_TEXELS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_VISIT_TEXELS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A texel is the closed square from (x, y) to (x + 1, y + 1). Of coordinates up to 2^16, a product and what is computed
// of it here have errors below 2^-32.
inline constexpr double rounding_tolerance = 1. / (1 << 24);

// std::floor() to int; without instructions of newer processors, it is a call.
inline int floor_of(double x)
{
  const int i = static_cast<int>(x);
  return i - (x < i);
}

// Calls `visit(y, first, last)` for each row with texels that a triangle or a segment touches, or comes nearer to than
// `tolerance`, which is at least the one above: an interval of each row, which may be longer by up to two tolerances at
// the ends. Whole `neighbours` in all directions count as well.
template <std::size_t N, typename Visit>
void visit_texels(const std::array<Planar_point, N>& corners, double tolerance, const Visit& visit,
                  double neighbours = 0)
{
  const double reach = neighbours + tolerance;
  double bottom = corners[0].y(), top = bottom;
  for(const Planar_point& p : corners) {
    bottom = (std::min)(bottom, p.y());
    top = (std::max)(top, p.y());
  }
  const int first_row = floor_of(bottom - reach), last_row = floor_of(top + reach);
  for(int y = first_row; y <= last_row; ++y) {
    const double lower = y - reach, upper = y + 1 + reach;
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for(std::size_t i = 0; i < (N == 2 ? 1 : N); ++i) {
      const Planar_point *p = &corners[i], *q = &corners[(i + 1) % N];
      if(q->y() < p->y())
        std::swap(p, q);
      if(q->y() < lower || p->y() > upper)
        continue;
      const auto x_at = [&](double height) {
        return p->x() + (height - p->y()) / (q->y() - p->y()) * (q->x() - p->x());
      };
      const double a = p->y() < lower ? x_at(lower) : p->x(), b = q->y() > upper ? x_at(upper) : q->x();
      left = (std::min)(left, (std::min)(a, b));
      right = (std::max)(right, (std::max)(a, b));
    }
    if(left <= right)
      visit(y, floor_of(left - reach - tolerance), floor_of(right + reach + tolerance));
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_VISIT_TEXELS_H
