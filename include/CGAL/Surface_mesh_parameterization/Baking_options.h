// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <optional>

/// \file Baking_options.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options of `bake_surface()`.
struct Baking_options
{
  int resolution = 1024; ///< Texels along each side of the square, from 1 to 16384.

  /// Number of texels around charts that are filled, from 0 to 1024. It should be at most `Packing_options::gutter`;
  /// between charts that are closer than two gutters, each texel belongs to the nearest chart.
  int gutter = 2;

  /// Length of rays to each side of the simple surface, in units of the surface; finite and above 0. If unset, the
  /// length is a twentieth of the diagonal of the bounding box of the simple surface.
  std::optional<double> ray_length;

  /// Whether normals are in the coordinates of the surface, instead of in tangent space.
  bool normals_in_object_space = false;

  int threads = 0; ///< As `Flattening_options::threads`.
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_OPTIONS_H
