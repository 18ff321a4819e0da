// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_FLATTEN_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_FLATTEN_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <functional>
#include <vector>

#ifdef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#define CGAL_ANGLE_BASED_FLATTENING_INLINE
#else
#define CGAL_ANGLE_BASED_FLATTENING_INLINE inline
#endif

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Rounds coordinates to what the caller can store.
typedef std::function<void(std::vector<Chart::Point_2>&)> Rounding;

// Flattens a coarse chart. Returns whether it succeeded.
typedef std::function<bool(const Chart&, std::vector<Chart::Point_2>&)> Coarse_flattening;

// Flattens a chart that `diagnose()` found flawless, directly. Returns `false` with the reason in `report`, and with the
// triangles that are wrong in `flipped`.
CGAL_ANGLE_BASED_FLATTENING_INLINE bool
flatten_chart(const Chart& chart, const ABF_plus_plus_options& options, const Linear_solvers& solvers,
              const Rounding& round, std::vector<Chart::Point_2>& uv, std::vector<int>& flipped,
              ABF_plus_plus_report& report);

// The same by way of a coarser chart; `solvers` solve the linear systems of polishing. The connectivity of the chart is
// changed on the way, and is as before if a valid map was found.
CGAL_ANGLE_BASED_FLATTENING_INLINE bool
flatten_chart_hierarchically(Chart& chart, const Hierarchical_options& options,
                             const Coarse_flattening& flatten_coarse, const Linear_solvers& solvers,
                             const Rounding& round, std::vector<Chart::Point_2>& uv,
                             std::vector<int>& flipped, Hierarchical_report& report);

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/ladder.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/flatten_chart_hierarchically.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_FLATTEN_CHART_H
