// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How far each vertex can be seen from outside, by rays: seams are better hidden, as Sheffer and Hart (2002) lay
// theirs. `seam_weights.h` makes edges expensive by it where they are well visible.
// Without the compiled library it brings in `visibility_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_VISIBILITY_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_VISIBILITY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <vector>

namespace CGAL::Texture_atlas::internal {

// For each vertex, the share of the rays into the half space of its normal that leave without meeting a triangle; 1 for
// vertices without a normal.
CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<double> visibility(const Triangle_arrays& mesh);

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/seams/visibility_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_VISIBILITY_H
