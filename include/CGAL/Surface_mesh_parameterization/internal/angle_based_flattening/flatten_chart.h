// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_FLATTEN_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_FLATTEN_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certify.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/least_squares_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/report_failure.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/target_angles.h>

#include <CGAL/Real_timer.h>

#include <string>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The seconds since the last call, and since construction at the first.
class Stopwatch
{
public:
  Stopwatch() { m_timer.start(); }

  double lap()
  {
    const double elapsed = m_timer.time();
    m_timer.reset();
    return elapsed;
  }

private:
  Real_timer m_timer;
};

// Whether the angles fit together so well that the exact layout reproduces them.
inline bool is_exact_layout_apt(const Chart& chart, const ABF_plus_plus_report& report)
{
  const double largest_residual = 1e-7;
  return chart.borders.size() == 1 && report.constraint_residual <= largest_residual;
}

// From angles to coordinates, in the way asked for. Returns `false` with the reason in `report`.
template <typename SolverTraits>
bool lay_out(const Chart& chart, const std::vector<double>& alpha, const ABF_plus_plus_options& options,
             const SolverTraits& traits, std::vector<Chart::Point_2>& uv, ABF_plus_plus_report& report)
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
    solved = exact_layout(chart, alpha, traits, layout);
    uv.swap(layout.uv);
    report.closure = layout.closure;
  } else {
    solved = Least_squares_layout(chart, alpha).solve(traits, uv);
  }
  report.layout = exact ? ABF_plus_plus_report::EXACT : ABF_plus_plus_report::LEAST_SQUARES;
  if(!solved)
    fail(report, ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, ABF_plus_plus_report::LINEAR_SYSTEM_FAILED,
         "the linear system of the layout could not be solved");
  return solved;
}

// Counts flipped triangles; returns `false` with the reason in `report` if there are any.
inline bool certify(const Chart& chart, const std::vector<Chart::Point_2>& uv, ABF_plus_plus_report& report,
                    std::vector<int>& flipped)
{
  flipped = flipped_triangles(chart, uv);
  report.flipped_triangles = static_cast<int>(flipped.size());
  if(flipped.empty())
    return true;
  const std::string count = std::to_string(flipped.size()) + " flipped triangle(s), one at the vertex at " +
                            place(chart, chart.vertex[3 * flipped.front()]);
  if(report.converged)
    fail(report, ERROR_NO_1_TO_1_MAPPING, ABF_plus_plus_report::FLIPPED_TRIANGLES,
         "the angles were found, but their layout has " + count);
  else
    fail(report, ERROR_NO_1_TO_1_MAPPING, ABF_plus_plus_report::NO_CONVERGENCE,
         "the angles did not converge, and their layout has " + count);
  return false;
}

// Flattens a chart that `diagnose()` found flawless. `uv` is scaled to the surface's area, and rounded by `round` to
// what the caller can store before it is certified. Returns `false` with the reason in `report`.
template <typename SolverTraits, typename Rounding>
bool flatten_chart(const Chart& chart, const ABF_plus_plus_options& options, SolverTraits traits,
                   Rounding& round, std::vector<Chart::Point_2>& uv, std::vector<int>& flipped,
                   ABF_plus_plus_report& report)
{
  Stopwatch stopwatch;
  const std::vector<double> beta = target_angles(chart);
  std::vector<double> alpha = starting_angles(beta);
  report.seconds.targets = stopwatch.lap();

  const bool solved = solve_angles(chart, beta, options, traits, alpha, report);
  report.seconds.angles = stopwatch.lap();
  if(!solved) {
    fail(report, ERROR_CANNOT_SOLVE_LINEAR_SYSTEM, ABF_plus_plus_report::LINEAR_SYSTEM_FAILED,
         "the linear system of Newton step " + std::to_string(report.iterations + 1) +
             " could not be solved");
    return false;
  }

  if(!lay_out(chart, alpha, options, traits, uv, report))
    return false;
  scale_to_surface_area(chart, uv);
  round(uv);
  report.seconds.layout = stopwatch.lap();

  const bool valid = certify(chart, uv, report, flipped);
  report.smallest_angle = smallest_angle(chart, uv);
  report.seconds.certify = stopwatch.lap();
  return valid;
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_FLATTEN_CHART_H
