// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>

/// \file Cone_options.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// How `select_cones()` finds the angles of the cones.
enum class Cone_angles
{
  PREDICTED,     ///< The predicted scale is 1 at all cones.
  LEAST_SQUARES, ///< The predicted scale varies as little as possible, in the mean over the area.

  /// The map determines the angles: all are `free_cone_angle`. A sphere may then have fewer than three cones.
  FREE
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options of `select_cones()` and `flatten_with_cones()`.
struct Cone_options
{
  Cone_angles angles = Cone_angles::PREDICTED; ///< How the angles of the cones are found.

  /// If not 0, the angles of the cones are multiples of this angle, in radians; \f$2\pi\f$ must be a multiple of it.
  /// With \f$\pi/2\f$, a grid continues across all seams. The surface must be a sphere or a disk, and `angles` must not
  /// be `FREE`.
  double angle_multiple = 0;

  /// The options of ABF++ in `flatten_with_cones()`. `ABF_plus_plus_options::equal_seam_lengths` may be `false` only
  /// with free angles.
  ABF_plus_plus_options parameterizer;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_CONE_OPTIONS_H
