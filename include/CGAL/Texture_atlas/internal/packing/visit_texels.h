// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// All texels that a triangle or segment touches, none missed whatever the rounding. `chart_shape.h` draws with it,
// `certify_packing_impl.h` relies on its bounds, and `baking/chart_texels.h` finds what to bake by it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_VISIT_TEXELS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_VISIT_TEXELS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL::Texture_atlas::internal {

// A texel is the closed square from (x, y) to (x + 1, y + 1). Of coordinates up to 2^16, a product and what is computed
// of it here have errors below 2^-32.
inline constexpr double rounding_tolerance = 1. / (1 << 24);

// std::floor() to int; without instructions of newer processors, it is a call.
inline int floor_of(double x)
{
  const int i = static_cast<int>(x);
  return i - (x < i);
}

// Calls `visit(y, first, last)` for each row with texels that a triangle touches, or comes nearer to than `tolerance`,
// which is at least the one above: an interval of each row, which may be longer by up to two tolerances at the ends.
template <typename Visit>
void visit_texels(const std::array<Planar_point, 3>& corners, double tolerance, const Visit& visit)
{
  double bottom = corners[0].y(), top = bottom;
  for(const Planar_point& p : corners) {
    bottom = (std::min)(bottom, p.y());
    top = (std::max)(top, p.y());
  }
  const int first_row = floor_of(bottom - tolerance), last_row = floor_of(top + tolerance);
  for(int y = first_row; y <= last_row; ++y) {
    const double lower = y - tolerance, upper = y + 1 + tolerance;
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for(std::size_t i = 0; i < 3; ++i) {
      const Planar_point *p = &corners[i], *q = &corners[(i + 1) % 3];
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
      visit(y, floor_of(left - 2 * tolerance), floor_of(right + 2 * tolerance));
  }
}

// The same for a segment, with one division for all rows. Whole `neighbours` in all directions count as well. The slope
// may be steep, but what it is multiplied with is no more than the difference of heights it was divided by.
template <typename Visit>
void visit_texels(const Planar_point& first, const Planar_point& second, double tolerance, const Visit& visit,
                  double neighbours = 0)
{
  const double reach = neighbours + tolerance, margin = reach + tolerance;
  const bool is_upward = first.y() <= second.y();
  const Planar_point &p = is_upward ? first : second, &q = is_upward ? second : first;
  const double slope = p.y() < q.y() ? (q.x() - p.x()) / (q.y() - p.y()) : 0;
  const int first_row = floor_of(p.y() - reach), last_row = floor_of(q.y() + reach);
  for(int y = first_row; y <= last_row; ++y) {
    const double lower = y - reach, upper = y + 1 + reach;
    if(q.y() < lower || p.y() > upper)
      continue;
    const double a = p.y() < lower ? p.x() + (lower - p.y()) * slope : p.x(),
                 b = q.y() > upper ? p.x() + (upper - p.y()) * slope : q.x();
    visit(y, floor_of((a < b ? a : b) - margin), floor_of((a < b ? b : a) + margin));
  }
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_VISIT_TEXELS_H
