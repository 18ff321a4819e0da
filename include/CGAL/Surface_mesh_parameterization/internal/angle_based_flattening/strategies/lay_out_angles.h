// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The way from planar angles to a certified map: the layout by Eqs. 19 to 21, or the exact one, and its certificate.
// `direct_strategies.h` ends each attempt with it; `flatten_chart_hierarchically.h` polishes with its parts.
//
// Refuses charts with holes on which any conformal map would shrink some part beyond use. `flatten_chart_directly.h`
// asks before it solves; `flatten_chart_hierarchically.h` asks on the coarse chart, where that is cheap.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_LAY_OUT_ANGLES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_LAY_OUT_ANGLES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/least_squares_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/predict_scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <cmath>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
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
       << " in the plane: cut the surface open from the border at "
       << vertex_text(chart, chart.edge_source(border.front())) << " to the outer border";
  fail(report, Diagnosis::SCALE_TOO_LARGE, text.str());
  return triangles;
}

// A flattening with its planar angles and the multipliers of their constraints
struct Direct_flattening : Flattening<ABF_plus_plus_report>
{
  std::vector<double> alpha;
  Constraint_vector multipliers;
};

// The layout asked for. The exact one reproduces angles that fit together so well, and keeps prescribed angles.
inline ABF_plus_plus_report::Layout choose_layout(const Chart& chart, const ABF_plus_plus_options& options,
                                                  double constraint_residual)
{
  typedef ABF_plus_plus_options Options;
  typedef ABF_plus_plus_report Report;
  const double largest_residual = 1e-4;
  switch(options.layout) {
  case Options::EXACT_LAYOUT:
    return Report::EXACT;
  case Options::AUTOMATIC_LAYOUT:
    return constraint_residual <= largest_residual || chart.has_prescribed_angles() ? Report::EXACT
                                                                                    : Report::LEAST_SQUARES;
  case Options::LEAST_SQUARES_LAYOUT:
    break;
  }
  return Report::LEAST_SQUARES;
}

// From angles to coordinates. Returns nothing if the linear solver fails.
inline std::optional<Layout> lay_out(const Chart& chart, const std::vector<double>& alpha,
                                     ABF_plus_plus_report::Layout kind, const Linear_solvers& solvers,
                                     std::unique_ptr<Linear_solver> scalar_solver)
{
  if(kind == ABF_plus_plus_report::EXACT) {
    if(chart.has_border_nodes()) // the pattern of the angles' system has border vertices
      scalar_solver = solvers->low_precision();
    return exact_layout(chart, alpha, *scalar_solver);
  }
  std::optional<std::vector<Chart::Point_2>> uv = Least_squares_layout(chart, alpha).solve(solvers);
  if(!uv)
    return std::nullopt;
  return Layout{std::move(*uv)};
}

inline void take_solution(Angle_solution& solution, Direct_flattening& result)
{
  ABF_plus_plus_report& report = result.report;
  report.converged = solution.converged;
  report.iterations = solution.iterations;
  report.energy = solution.energy;
  report.constraint_residual = solution.constraint_residual;
  report.steps = std::move(solution.steps);
  if(!solution.is_solved)
    fail(report, Diagnosis::LINEAR_SYSTEM_FAILED,
         "the linear system of Newton step " + std::to_string(report.iterations + 1) +
             " could not be solved");
  result.alpha = std::move(solution.alpha);
  result.multipliers = std::move(solution.multipliers);
}

// The coordinates of `part`, scaled to its area, and rounded to what the caller can store.
inline std::vector<Chart::Point_2>
find_coordinates(const Chart& chart, const Chart& part, const ABF_plus_plus_options& options,
                 const Linear_solvers& solvers, Rounding round, const std::vector<double>& alpha,
                 std::unique_ptr<Linear_solver> scalar_solver, ABF_plus_plus_report& report)
{
  const Stage stage(options.visitor, Flattening_visitor::LAYOUT, report.seconds.layout);
  report.layout = choose_layout(chart, options, report.constraint_residual);
  std::optional<Layout> layout = lay_out(chart, alpha, report.layout, solvers, std::move(scalar_solver));
  if(!layout) {
    fail(report, Diagnosis::LINEAR_SYSTEM_FAILED, "the linear system of the layout could not be solved");
    return {};
  }
  report.closure = layout->closure;
  report.layout_repeated = layout->is_repeated;
  layout->uv.resize(part.points.size());
  scale_to_surface_area(part, layout->uv);
  round(layout->uv);
  return std::move(layout->uv);
}

// Whether the map of `part` is valid; otherwise the report says what is wrong.
inline void certify_layout(const Chart& part, const ABF_plus_plus_options& options, Direct_flattening& result)
{
  ABF_plus_plus_report& report = result.report;
  Certificate certificate;
  {
    const Stage stage(options.visitor, Flattening_visitor::CERTIFY, report.seconds.certify);
    certificate = certify(part, result.uv);
  }
  take_certificate(certificate, report);
  report_prescribed_angles(part, result.uv, report);
  if(!certificate.is_valid()) {
    if(report.converged)
      fail(report, Diagnosis::FLIPPED_TRIANGLES,
           "the angles were found, but their layout has " + describe_invalid(part, certificate));
    else
      fail(report, Diagnosis::NO_CONVERGENCE,
           "the angles did not converge, and their layout has " + describe_invalid(part, certificate));
    result.invalid = std::move(certificate.invalid);
  } else if(part.has_prescribed_angles() && !report.converged) {
    fail(report, Diagnosis::NO_CONVERGENCE, "the angles did not converge to the prescribed ones");
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_LAY_OUT_ANGLES_H
