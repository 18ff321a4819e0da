// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The interface of the division along creases: `divide_at_creases()` on a chart, without a mesh.
// `select_crease_seams.h` includes it. Without the compiled library it brings in `crease_division_impl.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_DIVISION_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_DIVISION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal {

struct Crease_division
{
  std::vector<char> is_seam; // of each corner: whether the edge that it faces lies between parts
  std::size_t number_of_patches = 0;
  double area = 0,
         flat_area = 0; // the second is that of flat patches of at least two triangles, if there are others
  double curvature = 0; // the sum of what angles lack or exceed 2 pi at vertices within patches

  // Whether the surface is made of few patches that have maps without stretch
  bool is_developable() const { return number_of_patches <= 16 && curvature < 0.01; }
};

// Divides a surface along edges whose faces differ by more than `angle`, and joins what unfolds together. `cost` is
// that of the edge that each corner faces, infinity where it must not be a seam.
CGAL_ANGLE_BASED_FLATTENING_INLINE Crease_division divide_at_creases(const Chart& surface,
                                                                     const std::vector<double>& cost,
                                                                     double angle);

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/seams/crease_division_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_DIVISION_H
