// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The hierarchical and the injective method on a chart: refinement (Section 5) or descent, filled holes, polishing by
// the direct solver, and the certificate. The compiled library has it in `angle_based_flattening_hierarchical.cpp`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_HIERARCHICALLY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_HIERARCHICALLY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/flatten_injectively.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/coarse_to_fine.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/lay_out_angles.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/holes/fill_holes.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

struct Polished_map
{
  std::vector<Chart::Point_2> uv; // empty if no better valid map was found
  int iterations = 0;
  double energy = 0;
  double constraint_residual = 0;
};

// Runs the direct solver from the angles of a valid map, which fulfil all constraints.
inline Polished_map polish(const Chart& chart, const std::vector<Chart::Point_2>& uv,
                           const ABF_plus_plus_options& options, const Linear_solvers& solvers)
{
  const std::vector<double> beta = target_angles(chart);
  std::vector<double> alpha(beta.size());
  for(int c = 0; c < chart.number_of_corners(); ++c)
    alpha[c] = planar_angle(chart, uv, c);
  Angle_solution solution = solve_angles(chart, beta, options, solvers, starting_angles(alpha));
  Polished_map result;
  result.iterations = solution.iterations;
  result.energy = solution.energy;
  result.constraint_residual = solution.constraint_residual;
  const ABF_plus_plus_report::Layout kind = choose_layout(chart, options, solution.constraint_residual);
  if(!solution.is_solved || !solution.converged)
    return result;
  std::optional<Layout> layout =
      lay_out(chart, solution.alpha, kind, solvers, std::move(solution.scalar_solver));
  if(layout && is_valid_map(chart, layout->uv))
    result.uv = std::move(layout->uv);
  return result;
}

inline void polish(const Chart& chart, const Hierarchical_options& options, const Linear_solvers& solvers,
                   Flattening<Hierarchical_report>& result)
{
  const Stage stage(options.visitor, Flattening_visitor::POLISH, result.report.seconds.polish);
  const Deadline deadline(options.polish_options.time_limit);
  Polished_map map;
  result.report.polishing_timed_out =
      !deadline.allows([&] { map = polish(chart, result.uv, options.polish_options, solvers); });
  result.report.polish_iterations = map.iterations;
  result.report.constraint_residual = map.constraint_residual;
  result.report.polished = !map.uv.empty();
  if(result.report.polished) {
    result.uv = std::move(map.uv);
    result.report.energy = map.energy;
  }
}

// The map before it is certified
inline Flattening<Hierarchical_report> refined_map(Chart& chart, const Hierarchical_options& options,
                                                   const Coarse_flattening& flatten_coarse,
                                                   const Linear_solvers& solvers,
                                                   const std::vector<Chart::Point_2>* start = nullptr)
{
  // The range of scale is predicted on the coarse chart: on the fine one, that would take longer than all the rest.
  if(options.injective)
    return flatten_injectively(chart, options, solvers, start);
  Hierarchical_report prediction;
  const Coarse_flattening flatten_if_possible = [&](const Chart& coarse) -> Coarse_map {
    prediction = Hierarchical_report();
    limit_scale(coarse, solvers, prediction);
    if(prediction.status == Diagnosis::NOTHING_WRONG)
      return flatten_coarse(coarse);
    Coarse_map none(std::nullopt);
    none.message = prediction.message;
    return none;
  };
  Flattening<Hierarchical_report> result = flatten_coarse_to_fine(chart, options, flatten_if_possible);
  result.report.predicted_scale_range = prediction.predicted_scale_range;
  if(!result.succeeded() && prediction.status != Diagnosis::NOTHING_WRONG)
    fail(result.report, prediction.status, prediction.message);
  if(result.succeeded() && options.polish)
    polish(chart, options, solvers, result);
  return result;
}

// The same, with filled holes
inline Flattening<Hierarchical_report> refined_map_of_filled(const Chart& chart,
                                                             const Hierarchical_options& options,
                                                             const Coarse_flattening& flatten_coarse,
                                                             const Linear_solvers& solvers)
{
  Chart filled;
  double seconds = 0;
  {
    const Stage stage(nullptr, Flattening_visitor::COARSEN, seconds);
    filled = fill_holes(chart, soft_patch_weight);
  }
  Flattening<Hierarchical_report> result = refined_map(filled, options, flatten_coarse, solvers);
  result.report.seconds.coarsen += seconds;
  result.report.holes_filled = true;
  result.uv.resize(chart.points.size());
  const Hierarchical_report sizes = report_of<Hierarchical_report>(chart);
  result.report.vertices = sizes.vertices;
  result.report.triangles = sizes.triangles;
  result.report.borders = sizes.borders;
  return result;
}

// Whether the coarse chart would consist of little but holes
inline bool has_many_holes(const Chart& chart, const Hierarchical_options& options)
{
  const double coarse_vertices = options.coarse_triangles > 0
                                     ? options.coarse_triangles / 2.
                                     : (1 - options.simplification_rate) * chart.number_of_vertices();
  return chart.number_of_holes() > 0.1 * coarse_vertices;
}

// With the holes solved if that is possible
inline Flattening<Hierarchical_report> refined_map_with_holes(Chart& chart,
                                                              const Hierarchical_options& options,
                                                              const Coarse_flattening& flatten_coarse,
                                                              const Linear_solvers& solvers)
{
  if(options.injective || options.holes == Flattening_options::FILL)
    return refined_map_of_filled(chart, options, flatten_coarse, solvers);
  std::vector<Hierarchical_report::Failed_coarse_chart> failed;
  std::string reason = "the coarse chart would consist of little but holes";
  if(!options.fallbacks || !has_many_holes(chart, options)) {
    const Chart original = chart;
    Flattening<Hierarchical_report> result = refined_map(chart, options, flatten_coarse, solvers);
    if(result.report.status != Diagnosis::NO_CONVERGENCE)
      return result;
    chart = original;
    failed = std::move(result.report.failed_coarse_charts);
    reason = failed.empty() ? result.report.message : failed.back().message;
  }
  Flattening<Hierarchical_report> result = refined_map_of_filled(chart, options, flatten_coarse, solvers);
  Hierarchical_report& report = result.report;
  report.failed_coarse_charts.insert(report.failed_coarse_charts.begin(), failed.begin(), failed.end());
  if(result.succeeded())
    report.note =
        "holes were filled instead of solved: " + reason + (report.note.empty() ? "" : "; ") + report.note;
  return result;
}

// Why a map that was computed to be valid is not, after it was scaled and rounded
inline void fail_to_certify(const Chart& chart, const Hierarchical_options& options,
                            const Certificate& certificate, bool was_valid,
                            Flattening<Hierarchical_report>& result)
{
  const std::string defect = certificate.is_valid() ? describe_touching_edges(chart, result.uv)
                                                    : describe_invalid(chart, certificate);
  if(was_valid)
    fail(result.report, Diagnosis::PRECISION_EXCEEDED,
         "the map is valid, but after rounding to the coordinates' number type it has " + defect);
  else if(options.injective)
    fail(result.report, Diagnosis::PRECISION_EXCEEDED,
         "the map has " + defect +
             ", as its range of scale is too large for double precision; a larger area weight may help");
  else
    fail(result.report, Diagnosis::FLIPPED_TRIANGLES, "the refined map has " + defect);
}

inline void certify(const Chart& chart, const Hierarchical_options& options, Rounding round,
                    Flattening<Hierarchical_report>& result)
{
  const Stage stage(options.visitor, Flattening_visitor::CERTIFY, result.report.seconds.certify);
  scale_to_surface_area(chart, result.uv);
  const std::vector<Chart::Point_2> not_rounded = result.uv;
  round(result.uv);
  Certificate certificate = certify(chart, result.uv);
  take_certificate(certificate, result.report);
  result.report.injective = options.injective && certificate.is_valid() && certificate.border_is_simple;
  if(!certificate.is_valid() || (options.injective && !certificate.border_is_simple))
    fail_to_certify(chart, options, certificate,
                    is_valid_map(chart, not_rounded) &&
                        (!options.injective || is_border_simple(chart, not_rounded)),
                    result);
  result.invalid = std::move(certificate.invalid);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<Hierarchical_report>
flatten_chart_hierarchically(Chart chart, const Hierarchical_options& options,
                             const Coarse_flattening& flatten_coarse, const Linear_solvers& solvers,
                             Rounding round, const std::vector<Chart::Point_2>* start)
{
  Flattening<Hierarchical_report> result =
      chart.borders.size() > 1 ? refined_map_with_holes(chart, options, flatten_coarse, solvers)
                               : refined_map(chart, options, flatten_coarse, solvers, start);
  if(result.succeeded())
    certify(chart, options, round, result);
  return result;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::optional<std::vector<Chart::Point_2>>
progressive_embedding(Chart chart, const ABF_plus_plus_options& options)
{
  Hierarchical_options hierarchical;
  hierarchical.barrier = options.barrier;
  hierarchical.angle_sweeps = 10;
  hierarchical.max_retries = 0;
  hierarchical.visitor = options.visitor;
  const auto no_solver = [](const Chart&) { return std::optional<std::vector<Chart::Point_2>>(); };
  Flattening<Hierarchical_report> result = flatten_coarse_to_fine(chart, hierarchical, no_solver);
  if(!result.succeeded())
    return std::nullopt;
  return std::move(result.uv);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_HIERARCHICALLY_H
