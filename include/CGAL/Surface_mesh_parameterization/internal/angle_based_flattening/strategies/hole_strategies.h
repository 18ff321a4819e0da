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
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/direct_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_from_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/optional_strategies.h>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The same patches, so many times as stiff.
inline void stiffen_patches(const Chart& chart, double factor, Chart& filled)
{
  for(int t = chart.number_of_triangles(); t < filled.number_of_triangles(); ++t)
    filled.weight[t] *= factor;
}

// The strategies for a chart with holes. The filled chart is a disk, so that the last one finds a valid map.
class Hole_strategies : Direct_strategies
{
  typedef ABF_plus_plus_report Report;

public:
  // `filled` becomes what `fill_holes()` makes of `chart`, if that is needed.
  Hole_strategies(Chart& filled, const Chart& chart, const ABF_plus_plus_options& options,
                  const Linear_solvers& solvers, Rounding round)
      : Direct_strategies(filled, chart, options, solvers, round), m_filled(filled)
  {}

  // Solves the holes; if that fails, solves them from the angles of the filled chart; if that fails too, keeps the
  // filled chart.
  Flattening<Report> solve()
  {
    Direct_flattening result = solve_from(starting_angles(targets(m_part)), Report::FROM_TARGET_ANGLES);
    // A map that is valid by chance, with holes that do not close, is not what was asked for.
    if(result.succeeded() && !result.report.converged && m_options.fallbacks)
      fail(result.report, Diagnosis::NO_CONVERGENCE, "the angles did not converge");
    if(!m_options.fallbacks || !can_patches_help(result))
      return finished(std::move(result));
    if(optional_strategies.fill_holes == nullptr) {
      fail(result.report, result.report.status,
           needs_strategies(result.report.message + "; filling the holes instead"));
      return finished(std::move(result));
    }
    note_failure(result);
    result = flatten_filled();
    if(result.succeeded()) {
      std::vector<double> alpha = result.alpha;
      alpha.resize(m_part.vertex.size()); // they meet all constraints of the chart without its patches
      Direct_flattening solved = solve_from(starting_angles(alpha), Report::FROM_SOFT_PATCHES);
      if(solved.succeeded() && solved.report.converged)
        return finished(std::move(solved));
      note_failure(solved);
    }
    return finished(rescued(std::move(result)));
  }

  Flattening<Report> fill()
  {
    Direct_flattening result = flatten_filled();
    return finished(m_options.fallbacks ? rescued(std::move(result)) : std::move(result));
  }

private:
  // The system of a hole of few triangles may be singular where that of the filled chart is not.
  static bool can_patches_help(const Direct_flattening& result)
  {
    return can_fallbacks_help(result) || result.report.status == Diagnosis::LINEAR_SYSTEM_FAILED;
  }

  std::vector<double> targets(const Chart& chart)
  {
    const Stage stage(m_options.visitor, Flattening_visitor::TARGET_ANGLES, m_seconds.targets);
    return target_angles(chart);
  }

  Direct_flattening solve_from(std::vector<double> start, Report::Strategy strategy)
  {
    Direct_flattening result = flatten_from_angles(m_part, m_part, m_options, m_solvers, m_round,
                                                   target_angles(m_part), std::move(start));
    m_seconds += result.report.seconds;
    result.report.strategy = strategy;
    return result;
  }

  Direct_flattening flatten_filled()
  {
    {
      const Stage stage(m_options.visitor, Flattening_visitor::TARGET_ANGLES, m_seconds.targets);
      m_filled = optional_strategies.fill_holes(m_part, soft_patch_weight);
      m_beta = target_angles(m_filled);
    }
    return flatten_with_patches(Report::SOFT_PATCHES);
  }

  Direct_flattening flatten_with_patches(Report::Strategy strategy)
  {
    Direct_flattening result = flatten(m_options, starting_angles(m_beta));
    result.report.strategy = strategy;
    return result;
  }

  // `result` if it is valid, and otherwise the result of other strategies on the filled chart
  Direct_flattening rescued(Direct_flattening result)
  {
    if(!can_fallbacks_help(result))
      return result;
    note_failure(result);
    stiffen_patches(m_part, 1 / soft_patch_weight, m_filled);
    result = flatten_with_patches(Report::STIFF_PATCHES);
    if(result.succeeded())
      return result;
    return start_from_embedding(std::move(result));
  }

  Chart& m_filled;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_HOLE_STRATEGIES_H
