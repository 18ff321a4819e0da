// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The interface of the methods on a chart, without a mesh. `run_parameterizer.h`, `atlas/` and `cones/` call it, and
// include the bodies in programs without the compiled library, which has them. The bodies tell who tries what, best
// read in this order:
// 1. Direct: `flatten_chart_directly.h` tries strategies until a map is valid, `direct_strategies.h` has each of them,
//    `lay_out_angles.h` ends each with a map, and `hole_strategies.h` is for charts with holes.
// 2. Hierarchical: `flatten_chart_hierarchically.h` has the coarse chart solved, polishes and certifies;
//    `coarse_to_fine.h` is Section 5 of the paper.
// 3. Injective: `injective/flatten_injectively.h` makes the map, also where that of the direct method overlaps itself.
// 4. Pins: `pin_map.h` moves a finished map.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Flattens a chart that `diagnose()` found flawless, directly; starts from the angles `last` of an earlier map if they
// are given and are those of the same triangles.
CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<ABF_plus_plus_report>
flatten_chart(const Chart& chart, const ABF_plus_plus_options& options, const Linear_solvers& solvers,
              Rounding round, const Planar_angles* last = nullptr);

// The same by way of a coarser chart, which the given one becomes; `solvers` solve the linear systems of polishing. An
// injective map of a disk starts from the injective map `start` if there is one.
CGAL_ANGLE_BASED_FLATTENING_INLINE Flattening<Hierarchical_report>
flatten_chart_hierarchically(Chart chart, const Hierarchical_options& options,
                             const Coarse_flattening& flatten_coarse, const Linear_solvers& solvers,
                             Rounding round, const std::vector<Chart::Point_2>* start = nullptr);

// The last resort of the direct method, by means of the hierarchical one: simplifies a copy of the chart to one
// triangle, and puts all vertices back where their triangles are valid. Returns nothing if double precision does not
// hold such a map.
CGAL_ANGLE_BASED_FLATTENING_INLINE std::optional<std::vector<Chart::Point_2>>
progressive_embedding(Chart chart, const ABF_plus_plus_options& options);

// The weight of patches that hardly stiffen a chart. With 1e-2 and less Newton's method does not converge.
inline constexpr double soft_patch_weight = 0.1;

// Makes a disk of a chart with holes, by patches of this weight behind its own triangles. The body is in
// `holes/fill_holes.h`.
CGAL_ANGLE_BASED_FLATTENING_INLINE Chart fill_holes(const Chart& chart, double weight);

// Moves the map `result` of a chart with pins to these, rounds it, and certifies it again.
CGAL_ANGLE_BASED_FLATTENING_INLINE void pin_map(const Chart& chart, const Flattening_options& options,
                                                const Linear_solvers& solvers, Rounding round,
                                                Flattening<ABF_plus_plus_report>& result);

CGAL_ANGLE_BASED_FLATTENING_INLINE void pin_map(const Chart& chart, const Flattening_options& options,
                                                const Linear_solvers& solvers, Rounding round,
                                                Flattening<Hierarchical_report>& result);

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_FLATTEN_CHART_H
