// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_FLATTEN_FROM_ANGLES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_FLATTEN_FROM_ANGLES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/least_squares_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/report_failure.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/stopwatch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Whether the angles fit together so well that the exact layout reproduces them.
inline bool is_exact_layout_apt(const Chart& chart, const ABF_plus_plus_report& report)
{
  const double largest_residual = 1e-4;
  return chart.borders.size() == 1 && report.constraint_residual <= largest_residual;
}

// From angles to coordinates, in the way asked for. Returns `false` with the reason in `report`.
inline bool lay_out(const Chart& chart, const std::vector<double>& alpha,
                    const ABF_plus_plus_options& options, const Linear_solvers& solvers,
                    std::unique_ptr<Linear_solver> scalar_solver, std::vector<Chart::Point_2>& uv,
                    ABF_plus_plus_report& report)
{
  typedef ABF_plus_plus_options Options;
  if(options.layout == Options::EXACT_LAYOUT && chart.borders.size() != 1) {
    fail(report, ERROR_WRONG_PARAMETER, ABF_plus_plus_report::WRONG_LAYOUT,
         "the exact layout needs a chart with one border; take the least squares layout");
    return false;
  }
  const bool exact = options.layout == Options::EXACT_LAYOUT ||
                     (options.layout == Options::AUTOMATIC_LAYOUT && is_exact_layout_apt(chart, report));
  bool solved;
  if(exact) {
    Layout layout;
    solved = exact_layout(chart, alpha, solvers, std::move(scalar_solver), layout);
    uv.swap(layout.uv);
    report.closure = layout.closure;
    report.layout_repeated = layout.is_repeated;
  } else {
    solved = Least_squares_layout(chart, alpha).solve(solvers, uv);
  }
  report.layout = exact ? ABF_plus_plus_report::EXACT : ABF_plus_plus_report::LEAST_SQUARES;
  if(!solved)
    fail(report, ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, ABF_plus_plus_report::LINEAR_SYSTEM_FAILED,
         "the linear system of the layout could not be solved");
  return solved;
}

// The triangles around interior vertices around which they wind more than once, although none is flipped.
inline std::vector<int> wound_triangles(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  const std::vector<int> sweeps = sweeps_over_axis(chart.vertex, uv);
  std::vector<int> wound;
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(const int v = chart.vertex[c]; chart.interior[v] >= 0 && sweeps[v] != 1)
      if(wound.empty() || wound.back() != c / 3)
        wound.push_back(c / 3);
  return wound;
}

// What is looked at in the end, whichever way the coordinates came: orientations, by exact predicates, the border, and how
// large triangles are. Returns `false`, with the triangles that make the map invalid, if it is.
template <typename Report>
bool inspect(const Chart& chart, const std::vector<Chart::Point_2>& uv, Report& report,
             std::vector<int>& invalid)
{
  invalid = flipped_triangles(chart, uv);
  report.flipped_triangles = static_cast<int>(invalid.size());
  if(invalid.empty())
    invalid = wound_triangles(chart, uv);
  report.border_is_simple = is_border_simple(chart, uv);
  report.smallest_angle = smallest_angle(chart, uv);
  report.scale_range = scale_range(chart, uv);
  return invalid.empty();
}

template <typename Report>
std::string describe_invalid(const Chart& chart, const std::vector<int>& invalid, const Report& report)
{
  return std::to_string(invalid.size()) +
         (report.flipped_triangles > 0 ? " flipped triangle(s)"
                                       : " triangle(s) that wind around a vertex more than once") +
         ", one at the vertex at " + place(chart, chart.vertex[3 * invalid.front()]);
}

// From angles `alpha` near to the solution to a certified layout: the first and the third rung of the ladder, and most of
// the second. `uv` is scaled to the surface's area, and rounded by `round` to what the caller can store before it is
// certified. Returns `false` with the reason in `report`.
inline bool flatten_from_angles(const Chart& chart, const ABF_plus_plus_options& options,
                                const Linear_solvers& solvers, const Rounding& round,
                                const std::vector<double>& beta, std::vector<double>& alpha,
                                std::vector<Chart::Point_2>& uv, std::vector<int>& flipped,
                                ABF_plus_plus_report& report)
{
  Stopwatch stopwatch;
  std::unique_ptr<Linear_solver> scalar_solver;
  visit_stage(options.visitor, Flattening_visitor::ANGLES);
  const bool solved = solve_angles(chart, beta, options, solvers, alpha, report, &scalar_solver);
  report.seconds.angles += stopwatch.lap();
  if(!solved) {
    fail(report, ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, ABF_plus_plus_report::LINEAR_SYSTEM_FAILED,
         "the linear system of Newton step " + std::to_string(report.iterations + 1) +
             " could not be solved");
    return false;
  }

  visit_stage(options.visitor, Flattening_visitor::LAYOUT);
  uv.clear();
  if(!lay_out(chart, alpha, options, solvers, std::move(scalar_solver), uv, report))
    return false;
  scale_to_surface_area(chart, uv);
  round(uv);
  report.seconds.layout += stopwatch.lap();

  visit_stage(options.visitor, Flattening_visitor::CERTIFY);
  const bool valid = inspect(chart, uv, report, flipped);
  report.seconds.certify += stopwatch.lap();
  if(valid)
    return true;
  if(report.converged)
    fail(report, ERROR_NO_1_TO_1_MAPPING, ABF_plus_plus_report::FLIPPED_TRIANGLES,
         "the angles were found, but their layout has " + describe_invalid(chart, flipped, report));
  else
    fail(report, ERROR_NO_1_TO_1_MAPPING, ABF_plus_plus_report::NO_CONVERGENCE,
         "the angles did not converge, and their layout has " + describe_invalid(chart, flipped, report));
  return false;
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_FLATTEN_FROM_ANGLES_H
