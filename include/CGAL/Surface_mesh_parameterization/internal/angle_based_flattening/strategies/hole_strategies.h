// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The direct method on charts with holes: refuses scales out of range, then tries equations for the holes, then fills
// the holes with patches, soft or stiff. `flatten_chart_directly.h` runs it. The paper's constraints are those of a
// disk.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_HOLE_STRATEGIES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_HOLE_STRATEGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/direct_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/lay_out_angles.h>

#include <optional>
#include <utility>
#include <vector>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/holes/fill_holes.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A chart whose holes are filled with patches after its own triangles, and its target angles
struct Filled_chart
{
  Chart chart;
  std::vector<double> target_angles;
};

inline Filled_chart fill_holes(const Chart& chart, const ABF_plus_plus_options& options, Attempts& attempts)
{
  const Stage stage(options.visitor, Flattening_visitor::TARGET_ANGLES, attempts.seconds.targets);
  Filled_chart result;
  result.chart = fill_holes(chart, soft_patch_weight);
  result.target_angles = target_angles(result.chart);
  return result;
}

// The same, with patches so many times as stiff
inline Filled_chart stiffen_patches(Filled_chart filled, const Chart& part, double factor)
{
  for(int t = part.number_of_triangles(); t < filled.chart.number_of_triangles(); ++t)
    filled.chart.weight[t] *= factor;
  return filled;
}

// `soft` is the map with soft patches. If it is not valid, stiff ones and the embedding are tried.
inline Direct_flattening rescue(Direct_flattening soft, Filled_chart filled, const Direct_task& task,
                                Attempts& attempts)
{
  if(!can_fallbacks_help(soft))
    return soft;
  attempts.note_failure(soft);
  const Filled_chart stiff = stiffen_patches(std::move(filled), task.part, 1 / soft_patch_weight);
  Direct_strategies strategies({stiff.chart, task.part, task.options, task.solvers, task.round},
                               stiff.target_angles, attempts);
  Direct_flattening result = strategies.flatten(task.options, starting_angles(stiff.target_angles),
                                                ABF_plus_plus_report::STIFF_PATCHES);
  if(result.succeeded())
    return result;
  attempts.note_failure(result);
  return strategies.from_embedding();
}

// What is tried where equations for the holes gave no map: from the angles of the filled chart, and else that chart's
// own map
inline Direct_flattening solve_by_filling(Direct_strategies& strategies, const Direct_task& task,
                                          Attempts& attempts)
{
  Filled_chart filled = fill_holes(task.part, task.options, attempts);
  Direct_strategies on_filled({filled.chart, task.part, task.options, task.solvers, task.round},
                              filled.target_angles, attempts);
  Direct_flattening result = on_filled.flatten(task.options, starting_angles(filled.target_angles),
                                               ABF_plus_plus_report::SOFT_PATCHES);
  if(result.succeeded()) {
    std::vector<double> alpha = result.alpha;
    alpha.resize(task.part.vertex.size()); // they meet all constraints of the chart without its patches
    Direct_flattening solved =
        strategies.flatten(task.options, starting_angles(alpha), ABF_plus_plus_report::FROM_SOFT_PATCHES);
    if(solved.succeeded() && solved.report.converged)
      return solved;
    attempts.note_failure(solved);
  }
  return rescue(std::move(result), std::move(filled), task, attempts);
}

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
  attempts.note_failure(result);
  return solve_by_filling(strategies, task, attempts);
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

// The map of the chart with filled holes (`Flattening_options::FILL`)
inline Flattening<ABF_plus_plus_report> flatten_filled(const Direct_task& task)
{
  Attempts attempts;
  Filled_chart filled = fill_holes(task.part, task.options, attempts);
  Direct_strategies strategies({filled.chart, task.part, task.options, task.solvers, task.round},
                               filled.target_angles, attempts);
  Direct_flattening result = strategies.flatten(task.options, starting_angles(filled.target_angles),
                                                ABF_plus_plus_report::SOFT_PATCHES);
  if(task.options.fallbacks)
    result = rescue(std::move(result), std::move(filled), task, attempts);
  return attempts.finish(task, std::move(result));
}

inline Flattening<ABF_plus_plus_report> flatten_with_holes(const Direct_task& task, const Planar_angles* last)
{
  Flattening<ABF_plus_plus_report> refusal;
  refusal.report = report_of<ABF_plus_plus_report>(task.chart);
  refusal.invalid = limit_scale(task.chart, task.solvers, refusal.report);
  if(!refusal.succeeded())
    return refusal;
  Flattening<ABF_plus_plus_report> result =
      task.options.holes == Flattening_options::FILL ? flatten_filled(task) : solve_holes(task, last);
  result.report.predicted_scale_range = refusal.report.predicted_scale_range;
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_HOLE_STRATEGIES_H
