// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_DIRECTLY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_DIRECTLY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/direct_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/patch_strategies.h>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<ABF_plus_plus_report>
flatten_chart(const Chart& chart, const ABF_plus_plus_options& options, const Linear_solvers& solvers,
              Rounding round)
{
  if(!are_holes_filled(chart, options))
    return Direct_strategies(chart, chart, options, solvers, round).run();
  Chart filled;
  return Patch_strategies(filled, chart, options, solvers, round).run();
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_DIRECTLY_H
