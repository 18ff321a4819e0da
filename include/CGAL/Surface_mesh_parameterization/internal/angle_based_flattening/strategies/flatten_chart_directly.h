// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The body of `flatten_chart()`: refuses scales out of range, and picks the strategies for disks or for holes.
// `flatten_chart.h` includes it in programs without the compiled library, which has it in
// `angle_based_flattening_direct.cpp`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_DIRECTLY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_DIRECTLY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/direct_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/hole_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/limit_scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/optional_strategies.h>

#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The map may overlap itself.
inline Flattening<ABF_plus_plus_report> locally_injective_map(const Chart& chart,
                                                              const ABF_plus_plus_options& options,
                                                              const Linear_solvers& solvers, Rounding round)
{
  if(chart.borders.size() == 1)
    return Direct_strategies(chart, chart, options, solvers, round).run();
  Flattening<ABF_plus_plus_report> refusal;
  refusal.report = report_of<ABF_plus_plus_report>(chart);
  refusal.invalid = limit_scale(chart, solvers, refusal.report);
  if(!refusal.succeeded())
    return refusal;
  Chart filled;
  Hole_strategies strategies(filled, chart, options, solvers, round);
  Flattening<ABF_plus_plus_report> result =
      are_holes_filled(chart, options) ? strategies.fill() : strategies.solve();
  result.report.predicted_scale_range = refusal.report.predicted_scale_range;
  return result;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<ABF_plus_plus_report>
flatten_chart(const Chart& chart, const ABF_plus_plus_options& options, const Linear_solvers& solvers,
              Rounding round)
{
  Flattening<ABF_plus_plus_report> result = locally_injective_map(chart, options, solvers, round);
  return options.injective
             ? optional_strategies.make_injective(chart, options, solvers, round, std::move(result))
             : result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_DIRECTLY_H
