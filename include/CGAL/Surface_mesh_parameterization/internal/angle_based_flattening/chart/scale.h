// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Areas on the surface and in the plane, and the factor between both. A layout is scaled to the area of its surface
// here. The methods of `strategies/` call it after the layout. The measures, the certificate and the atlas need the
// areas.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SCALE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

inline double surface_area(const Corner_table& chart, int t)
{
  return std::sqrt(CGAL::squared_area(chart.points[chart.vertex[3 * t]],
                                      chart.points[chart.vertex[3 * t + 1]],
                                      chart.points[chart.vertex[3 * t + 2]]));
}

// Positive for triangles that are not flipped.
inline double planar_area(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv, int t)
{
  return CGAL::area(uv[chart.vertex[3 * t]], uv[chart.vertex[3 * t + 1]], uv[chart.vertex[3 * t + 2]]);
}

struct Total_areas
{
  double surface = 0, plane = 0;
};

// Areas of flipped triangles count positively, those that are not finite not at all.
inline Total_areas total_areas(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv)
{
  const int triangles = chart.number_of_triangles();
  Total_areas total;
  total.surface = parallel_sum(triangles, [&](int t) { return surface_area(chart, t); });
  total.plane = parallel_sum(triangles, [&](int t) {
    const double area = std::abs(planar_area(chart, uv, t));
    return std::isfinite(area) ? area : 0;
  });
  return total;
}

// The factor that gives a layout the area of the surface, or that of a square as wide as `chart.scale` if the surface
// has none.
inline double scale_to_surface(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv)
{
  const Total_areas total = total_areas(chart, uv);
  return std::sqrt((total.surface > 0 ? total.surface : 1) / total.plane) * chart.scale;
}

// Scales the planar chart to the area of the surface, and moves its lower left corner to the origin.
inline void scale_to_surface_area(const Corner_table& chart, std::vector<Corner_table::Point_2>& uv)
{
  const double factor = scale_to_surface(chart, uv);
  const auto corner = (CGAL::bounding_box(uv.begin(), uv.end()).min)();
  for(Corner_table::Point_2& p : uv)
    p = CGAL::ORIGIN + (p - corner) * factor;
}

// The longest edge of a layout over its shortest one
inline double scale_range(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv)
{
  double shortest = (std::numeric_limits<double>::infinity)(), longest = 0;
  for(int c = 0; c < chart.number_of_corners(); ++c) {
    const auto edge = uv[chart.edge_target(c)] - uv[chart.edge_source(c)];
    const double square = edge.squared_length();
    const double length =
        square > 1e-290 && square < 1e290 ? std::sqrt(square) : std::hypot(edge.x(), edge.y());
    shortest = (std::min)(shortest, length);
    longest = (std::max)(longest, length);
  }
  return longest / shortest;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SCALE_H
