// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The option `injective` of the direct method: keeps its own map if it is injective, and otherwise takes the map of the
// injective method. `flatten_chart_directly.h` ends with it. `injective/flatten_injectively.h` makes the map.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_MAKE_INJECTIVE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_MAKE_INJECTIVE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>

#include <optional>
#include <utility>
#include <vector>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_hierarchically.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The options of the injective map for the direct method
inline Hierarchical_options injective_options(const ABF_plus_plus_options& options)
{
  Hierarchical_options result;
  static_cast<Flattening_options&>(result) = options;
  result.polish = true;
  return result;
}

// Whether there is a map that overlaps itself, or other strategies may find one that does not
inline bool can_become_injective(const Flattening<ABF_plus_plus_report>& result, bool fallbacks)
{
  const Diagnosis diagnosis = result.report.status;
  return result.succeeded() ||
         (fallbacks &&
          (diagnosis == Diagnosis::NO_CONVERGENCE || diagnosis == Diagnosis::FLIPPED_TRIANGLES ||
           diagnosis == Diagnosis::SCALE_TOO_LARGE || diagnosis == Diagnosis::PRECISION_EXCEEDED));
}

// The direct method's own map if that is injective, and else the polished injective map of the hierarchical method.
inline Flattening<ABF_plus_plus_report> make_injective(const Chart& chart,
                                                       const ABF_plus_plus_options& options,
                                                       const Linear_solvers& solvers, Rounding round,
                                                       Flattening<ABF_plus_plus_report> direct)
{
  direct.report.injective = direct.succeeded() && direct.report.border_is_simple;
  if(direct.report.injective || !can_become_injective(direct, options.fallbacks))
    return direct;
  if(direct.succeeded())
    fail(direct.report, Diagnosis::OVERLAPPING, "the map has " + describe_touching_edges(chart, direct.uv));
  if(chart.has_prescribed_angles()) // they are not kept by what follows
    return direct;
  const auto no_solver = [](const Chart&) { return std::optional<std::vector<Chart::Point_2>>(); };
  Flattening<Hierarchical_report> injective =
      flatten_chart_hierarchically(chart, injective_options(options), no_solver, solvers, round);

  Flattening<ABF_plus_plus_report> result;
  result.uv = std::move(injective.uv);
  result.invalid = std::move(injective.invalid);
  ABF_plus_plus_report& report = result.report;
  static_cast<Flattening_report&>(report) = injective.report;
  report.failed_strategies = std::move(direct.report.failed_strategies);
  report.failed_strategies.push_back(
      {direct.report.strategy, direct.report.status, direct.report.message, direct.report.iterations});
  report.strategy = ABF_plus_plus_report::INJECTIVE_DESCENT;
  report.iterations = injective.report.polish_iterations;
  report.energy = injective.report.energy;
  report.seconds += direct.report.seconds;
  report.predicted_scale_range = direct.report.predicted_scale_range;
  if(result.succeeded())
    report_seams(chart, result.uv, report);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_MAKE_INJECTIVE_H
