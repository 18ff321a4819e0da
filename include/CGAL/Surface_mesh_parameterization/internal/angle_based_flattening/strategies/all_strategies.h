// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Enters all optional strategies, so that the methods can call what their options or failures ask for.
// `ABF_plus_plus_strategies.h` includes it, and the compiled library does.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_ALL_STRATEGIES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_ALL_STRATEGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/set_angle_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/disk_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/filled_hole_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/optional_strategies.h>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/holes/fill_holes.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Runs as that of the strategies for disks does.
inline const bool has_all_strategies = [] {
  optional_strategies.fill_holes = &fill_holes;
  optional_strategies.flatten_filled = &flatten_filled;
  optional_strategies.solve_by_filling = &solve_by_filling;
  return has_disk_strategies;
}();

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_ALL_STRATEGIES_H
