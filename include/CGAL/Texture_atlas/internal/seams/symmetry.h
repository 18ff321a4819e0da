// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The interface of symmetric seams on flat arrays, without a mesh. `symmetrize_seams.h` includes it. Without the
// compiled library it brings in `symmetry_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>
#include <CGAL/Texture_atlas/internal/seams/mirror_seams.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <vector>

namespace CGAL::Texture_atlas::internal {

// The plane in which the surface is most nearly symmetric. At least one triangle has an area.
CGAL_ANGLE_BASED_FLATTENING_INLINE Mirror_plane fit_mirror_plane(const Triangle_arrays& mesh);

// For each edge whether it is a seam, with the seams on side `kept` of the plane, -1 or 1, on both sides
CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<char>
mirror_seams(const Triangle_arrays& mesh, const Edge_graph& graph, const Mirror_plane& plane,
             const std::vector<char>& may_be_seam, const std::vector<char>& is_seam, int kept);

// The mean distance of the mirror images of seams from the seams
CGAL_ANGLE_BASED_FLATTENING_INLINE double
asymmetry_of_seams(const Edge_graph& graph, const std::vector<char>& is_seam, const Mirror_plane& plane);

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/seams/symmetry_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_H
