// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The direct method on charts with holes: equations for the holes first, then the holes filled with patches, soft or
// stiff. `flatten_chart_directly.h` runs it. The paper's constraints are those of a disk.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_HOLE_STRATEGIES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_HOLE_STRATEGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/direct_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_from_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/optional_strategies.h>

#include <optional>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The system of a hole of few triangles may be singular where that of the filled chart is not.
inline bool can_patches_help(const Direct_flattening& result)
{
  return can_fallbacks_help(result) || result.report.status == Diagnosis::LINEAR_SYSTEM_FAILED;
}

// With equations for the holes, and else by filling them
inline Direct_flattening cold_started_with_holes(Direct_strategies& strategies, const Direct_task& task,
                                                 Attempts& attempts)
{
  Direct_flattening result = strategies.flatten(task.options, starting_angles(strategies.target_angles()),
                                                ABF_plus_plus_report::FROM_TARGET_ANGLES);
  // A map that is valid by chance, with holes that do not close, is not what was asked for.
  if(result.succeeded() && !result.report.converged && task.options.fallbacks)
    fail(result.report, Diagnosis::NO_CONVERGENCE, "the angles did not converge");
  if(!task.options.fallbacks || !can_patches_help(result))
    return result;
  if(optional_strategies.solve_by_filling == nullptr) {
    fail(result.report, result.report.status,
         needs_strategies(result.report.message + "; filling the holes instead"));
    return result;
  }
  attempts.note_failure(result);
  return optional_strategies.solve_by_filling(strategies, task, attempts);
}

// The map of the chart with its holes (`Flattening_options::SOLVE`)
inline Flattening<ABF_plus_plus_report> solve_holes(const Direct_task& task, const Planar_angles* last)
{
  Attempts attempts;
  Direct_strategies strategies(task, attempts.target_angles(task.chart, task.options), attempts);
  std::optional<Direct_flattening> result = warm_started(strategies, task, last, attempts);
  if(!result)
    result = cold_started_with_holes(strategies, task, attempts);
  strategies.keep_angles(*result);
  return attempts.finish(task, std::move(*result));
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_HOLE_STRATEGIES_H
