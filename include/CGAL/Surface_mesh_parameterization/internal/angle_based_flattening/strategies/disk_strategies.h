// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Enters the optional strategies for disks without prescribed angles: those of injective maps.
// `all_strategies.h` includes it, and `atlas/flatten_atlas_chart.h`, whose charts are all disks.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_DISK_STRATEGIES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_DISK_STRATEGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/embedding_strategy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/optional_strategies.h>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/flatten_injectively.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_hierarchically.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/make_injective.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The initialization runs before `main()`, and more than once if several shared libraries include this header, with the
// same result.
inline const bool has_disk_strategies = [] {
  optional_strategies.from_embedding = &flatten_from_embedding;
  optional_strategies.make_injective = &made_injective;
  optional_strategies.flatten_injectively = &flatten_injectively;
  return true;
}();

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_DISK_STRATEGIES_H
