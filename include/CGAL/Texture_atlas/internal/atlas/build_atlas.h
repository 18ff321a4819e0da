// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The interface of the atlas without the caller's types, so that it can be compiled once in the library.
// `Mesh_atlas_builder` calls `build_atlas()`; the definition is in `build_atlas_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BUILD_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BUILD_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/atlas_options.h>
#include <CGAL/Texture_atlas/internal/atlas/part_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <vector>

namespace CGAL::Texture_atlas::internal {

// Makes the atlas of a surface. `weight` multiplies the lengths of each triangle in the plane; empty if all are 1. A
// part that cannot be flattened is skipped. If something else is wrong, the report says so.
CGAL_ANGLE_BASED_FLATTENING_INLINE Atlas build_atlas(const std::vector<Surface_part>& parts,
                                                     const std::vector<double>& weight,
                                                     const Atlas_settings& options,
                                                     const Linear_solvers& solvers, Rounding round);

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/atlas/build_atlas_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_BUILD_ATLAS_H
