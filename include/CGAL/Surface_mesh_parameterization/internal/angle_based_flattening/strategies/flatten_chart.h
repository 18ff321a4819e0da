// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The interface of both methods on a chart: `flatten_chart()` and `flatten_chart_hierarchically()`, without a mesh.
// Both parameterizers, `make_injective.h`, `atlas/` and `cones/` call them. The bodies are in the two headers of
// similar name.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Flattens a chart that `diagnose()` found flawless, directly; starts from the angles `last` of an earlier map if they
// are given and are those of the same triangles.
CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<ABF_plus_plus_report>
flatten_chart(const Chart& chart, const ABF_plus_plus_options& options, const Linear_solvers& solvers,
              Rounding round, const Planar_angles* last = nullptr);

// The same by way of a coarser chart, which the given one becomes; `solvers` solve the linear systems of polishing. An
// injective map of a disk starts from the injective map `start` if there is one.
// Programs without the compiled library include the header of that name to have it.
CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<Hierarchical_report>
flatten_chart_hierarchically(Chart chart, const Hierarchical_options& options,
                             const Coarse_flattening& flatten_coarse, const Linear_solvers& solvers,
                             Rounding round, const std::vector<Chart::Point_2>* start = nullptr);

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_directly.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_H
