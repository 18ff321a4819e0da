// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Refuses charts with holes on which any conformal map would shrink some part beyond use. `flatten_chart_directly.h`
// asks before it solves; `flatten_chart_hierarchically.h` asks on the coarse chart, where that is cheap.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_LIMIT_SCALE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_LIMIT_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/predict_scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <cmath>
#include <optional>
#include <sstream>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Doubles hold larger ranges, but such a map is of no use.
inline constexpr double largest_scale_range = 1e10;

// Predicts the range of scale of a chart with several borders. If it is too large, the report says so, and the
// triangles at the far border are returned. A prediction that fails refuses nothing.
template <typename Report>
std::vector<int> limit_scale(const Chart& chart, const Linear_solvers& solvers, Report& report)
{
  std::vector<int> triangles;
  if(chart.borders.size() < 2)
    return triangles;
  const std::optional<Scale_prediction> prediction = predict_scale(chart, solvers);
  if(!prediction)
    return triangles;
  report.predicted_scale_range = std::exp(prediction->log_range);
  if(report.predicted_scale_range <= largest_scale_range)
    return triangles;
  const std::vector<int>& border = chart.borders[prediction->far_border];
  for(int c : border)
    triangles.push_back(c / 3);
  std::ostringstream text; // with the exponent alone, since the factor itself may be too large for `double`
  text << "lengths would vary by a factor of about 1e" << std::floor(prediction->log_range / std::log(10.))
       << " in the plane: cut the surface open from the border at the vertex at "
       << position_text(chart, chart.edge_source(border.front())) << " to the outer border";
  fail(report, Diagnosis::SCALE_TOO_LARGE, text.str());
  return triangles;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_LIMIT_SCALE_H
