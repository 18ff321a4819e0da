// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_FIND_SEAMS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_FIND_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/seams.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Those that make a disk of a connected surface. `cost` is that of the edge that each corner faces, infinity where it must not be a seam.
CGAL_ANGLE_BASED_FLATTENING_INLINE Seams find_topological_seams(const Chart& surface,
                                                                const std::vector<double>& cost);

// Those that make a disk of it that can be flattened with little stretch
CGAL_ANGLE_BASED_FLATTENING_INLINE Seams find_seams(const Chart& surface, const std::vector<double>& cost,
                                                    const Seam_options& options,
                                                    const Linear_solvers& solvers);

// Shorter seams than `seams`, with the same ends inside the surface
CGAL_ANGLE_BASED_FLATTENING_INLINE Seams shorten_seams(const Chart& surface, const std::vector<double>& cost,
                                                       const std::vector<char>& seams);

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/find_seams_impl.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_FIND_SEAMS_H
