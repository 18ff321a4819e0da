// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

/// \file Seam_options.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options of `select_seams()`.
struct Seam_options
{
  /// The largest \f$L_2\f$ stretch that is predicted for a disk; at least 1. With an infinite bound, the surface is
  /// cut to disks and no further.
  double stretch_bound = 1.1;

  /// The largest number of terminals of each part of the surface: vertices that are joined to the seams because of
  /// their scale. It must not be negative.
  int maximum_number_of_terminals = 100;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_OPTIONS_H
