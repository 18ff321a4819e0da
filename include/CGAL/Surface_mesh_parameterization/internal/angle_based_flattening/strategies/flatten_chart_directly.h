// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The direct method on a chart: tries the strategies for disks one after the other, or those for holes. With the option
// `injective`, it keeps its map if that is injective, and otherwise takes that of `injective/flatten_injectively.h`.
// The compiled library has it in `angle_based_flattening_direct.cpp`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_DIRECTLY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_DIRECTLY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_differential.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/patch_layouts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/direct_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/hole_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/lay_out_angles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_hierarchically.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The injective map of the hierarchical method, as a result of the direct method. A map that is to preserve areas is not
// polished, because that lowers the energy of angles.
inline Flattening<ABF_plus_plus_report> injective_map(const Chart& chart,
                                                      const ABF_plus_plus_options& options,
                                                      const Linear_solvers& solvers, Rounding round)
{
  Hierarchical_options hierarchical;
  static_cast<Flattening_options&>(hierarchical) = options;
  hierarchical.polish = !is_isometric(options);
  const auto no_solver = [](const Chart&) { return std::optional<std::vector<Chart::Point_2>>(); };
  Flattening<Hierarchical_report> injective =
      flatten_chart_hierarchically(chart, hierarchical, no_solver, solvers, round);
  Flattening<ABF_plus_plus_report> result;
  result.uv = std::move(injective.uv);
  result.invalid = std::move(injective.invalid);
  static_cast<Flattening_report&>(result.report) = injective.report;
  result.report.strategy = ABF_plus_plus_report::INJECTIVE_DESCENT;
  result.report.iterations = injective.report.polish_iterations;
  result.report.energy = injective.report.energy;
  if(result.succeeded())
    report_seams(chart, result.uv, result.report);
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
  Flattening<ABF_plus_plus_report> result = injective_map(chart, options, solvers, round);
  ABF_plus_plus_report& report = result.report;
  report.failed_strategies = std::move(direct.report.failed_strategies);
  report.failed_strategies.push_back(
      {direct.report.strategy, direct.report.status, direct.report.message, direct.report.iterations});
  report.seconds += direct.report.seconds;
  report.predicted_scale_range = direct.report.predicted_scale_range;
  return result;
}

// Needles are thinner than target angles may be. A chart that unfolds without stretch keeps their shape nevertheless.
inline std::optional<Direct_flattening> unfold_needles(const Direct_task& task,
                                                       const std::vector<double>& beta)
{
  const Chart& chart = task.chart;
  if(&chart != &task.part || !chart.targets.empty() || chart.has_prescribed_angles() ||
     std::find(beta.begin(), beta.end(), least_target_angle) == beta.end())
    return std::nullopt;
  for(int c = 0; c < chart.number_of_corners();
      ++c) // most charts do not unfold, and most of their angles tell
    if(std::abs(beta[c] - surface_angle(chart, c)) > least_target_angle)
      return std::nullopt;
  const double largest_quasi_conformal_ratio = 1 + 1e-4;
  const int n = chart.number_of_triangles();
  std::vector<int> all(n);
  std::iota(all.begin(), all.end(), 0);
  const std::vector<int> patch(n, 0);
  std::vector<Chart::Point_2> layout(chart.vertex.size());
  Patch_unfolding(chart, patch, layout).run(all, 1);
  Direct_flattening result;
  result.uv.resize(chart.points.size());
  for(std::size_t c = 0; c < layout.size(); ++c)
    result.uv[chart.vertex[c]] = layout[c];
  for(int t : all)
    if(Triangle_differential(chart, result.uv, t).is_thinner(largest_quasi_conformal_ratio))
      return std::nullopt;
  scale_to_surface_area(chart, result.uv);
  task.round(result.uv);
  const Certificate certificate = certify(chart, result.uv);
  if(!certificate.is_valid())
    return std::nullopt;
  result.report = report_of<ABF_plus_plus_report>(chart);
  result.report.converged = true;
  result.report.layout = ABF_plus_plus_report::EXACT;
  take_certificate(certificate, result.report);
  return result;
}

// The strategies for a disk, one after the other until one gives a valid map
inline Flattening<ABF_plus_plus_report> flatten_disk(const Direct_task& task, const Planar_angles* last)
{
  Attempts attempts;
  Direct_strategies strategies(task, attempts.target_angles(task.chart, task.options), attempts);
  if(std::optional<Direct_flattening> unfolded = unfold_needles(task, strategies.target_angles()))
    return attempts.finish(task, *std::move(unfolded));
  std::optional<Direct_flattening> result = warm_started(strategies, task, last, attempts);
  if(!result)
    result = strategies.flatten(task.options, starting_angles(strategies.target_angles()),
                                ABF_plus_plus_report::FROM_TARGET_ANGLES);
  if(task.options.fallbacks && can_fallbacks_help(*result)) {
    attempts.note_failure(*result);
    result = strategies.raise_barrier();
    if(!result->succeeded()) {
      attempts.note_failure(*result);
      result = strategies.from_embedding();
    }
  }
  strategies.keep_angles(*result);
  return attempts.finish(task, std::move(*result));
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<ABF_plus_plus_report>
flatten_chart(const Chart& chart, const ABF_plus_plus_options& options, const Linear_solvers& solvers,
              Rounding round, const Planar_angles* last)
{
  if(options.injective && is_isometric(options)) {
    if(!chart.has_prescribed_angles())
      return injective_map(chart, options, solvers, round);
    Flattening<ABF_plus_plus_report> result;
    result.report = report_of<ABF_plus_plus_report>(chart);
    fail(result.report, Diagnosis::WRONG_OPTION,
         "injective maps with prescribed angles preserve angles alone: area_weight must be at most 0.1");
    return result;
  }
  const Direct_task task = {chart, chart, options, solvers, round};
  Flattening<ABF_plus_plus_report> result =
      chart.borders.size() == 1 ? flatten_disk(task, last) : flatten_with_holes(task, last);
  return options.injective ? make_injective(chart, options, solvers, round, std::move(result)) : result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_DIRECTLY_H
