// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

/// \file Packing_options.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// Options of `pack_charts()`.
struct Packing_options
{
  int resolution = 1024; ///< Number of texels along each side of the unit square, from 1 to 32768.

  /// Number of free texels between two charts, from 0 to 1024. Half as many, rounded up, are free at the border of the
  /// square.
  int gutter = 2;

  int number_of_rotations = 32; ///< Number of directions that are tried for large charts, from 1 to 1024.
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_OPTIONS_H
