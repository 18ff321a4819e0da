// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The bodies of `vertex_names.h`, which the compiled library has.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_VERTEX_NAMES_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_VERTEX_NAMES_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <cstddef>
#include <locale>
#include <sstream>
#include <string>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string point_text(double x, double y, double z)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << '(' << x << ", " << y << ", " << z << ')';
  return text.str();
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::string vertex_text(const Corner_table& chart, int v)
{
  const double s = chart.scale;
  const Corner_table::Point_3& p = chart.points[v];
  const Corner_table::Point_3 point(s * p.x(), s * p.y(), s * p.z());
  const std::size_t i = static_cast<std::size_t>(v);
  return i < chart.numbers.size() ? vertex_text(chart.numbers[i], point)
                                  : "the vertex at " + point_text(point);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_VERTEX_NAMES_IMPL_H
