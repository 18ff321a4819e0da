// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_PATCH_STRATEGIES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_PATCH_STRATEGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/holes/fill_holes.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/direct_strategies.h>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The strategies for a chart whose holes are filled, a disk. As for any disk, the last one finds a valid map.
class Patch_strategies : Direct_strategies
{
  typedef ABF_plus_plus_report Report;

public:
  // `filled` becomes what `fill_holes()` makes of `chart`.
  Patch_strategies(Chart& filled, const Chart& chart, const ABF_plus_plus_options& options,
                   const Linear_solvers& solvers, Rounding round)
      : Direct_strategies(filled, chart, options, solvers, round), m_filled(filled)
  {}

  Flattening<Report> run()
  {
    {
      const Stage stage(m_options.visitor, Flattening_visitor::TARGET_ANGLES, m_seconds.targets);
      m_filled = fill_holes(m_part);
      m_beta = target_angles(m_filled);
    }
    Direct_flattening result = flatten_with_patches(Report::SOFT_PATCHES);
    if(m_options.fallbacks && can_fallbacks_help(result)) {
      note_failure(result);
      stiffen_patches(m_part, 1 / soft_patch_weight, m_filled);
      result = flatten_with_patches(Report::STIFF_PATCHES);
      if(!result.succeeded()) {
        note_failure(result);
        result = start_from_embedding();
      }
    }
    return finished(std::move(result));
  }

private:
  Direct_flattening flatten_with_patches(Report::Strategy strategy)
  {
    Direct_flattening result = flatten(m_options, starting_angles(m_beta));
    result.report.strategy = strategy;
    return result;
  }

  Chart& m_filled;
};

// The first of `alpha`, those of the chart without its patches. If the solver converged, they meet all constraints of the chart and
// close around its holes.
inline std::vector<double> angles_without_patches(const Chart& chart, std::vector<double> alpha)
{
  alpha.resize(chart.vertex.size());
  return alpha;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_PATCH_STRATEGIES_H
