// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The interface of baking without the caller's types, so that it can be compiled once in the library.
// `bake_mesh.h` calls `bake()`. Baked normals are what the paper shows in Section 6.1 and Figure 9.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_BAKE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_BAKE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Texture_atlas/internal/baking/shaded_surfaces.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <vector>

namespace CGAL::Texture_atlas::internal {

// What baking computes
struct Baking
{
  Baked_textures textures;
  std::vector<Tangent_frame> frames; // of each corner of the simple surface
};

// Bakes the fine surface into textures of the simple one. Coordinates of both are finite, and at most about 1 in the
// simple one. The fine surface has a triangle with area.
CGAL_ANGLE_BASED_FLATTENING_INLINE Baking bake(Charted_surface simple, Painted_surface fine,
                                               const Baking_options& options);

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/baking/bake_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_BAKE_H
