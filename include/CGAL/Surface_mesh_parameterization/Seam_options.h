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
/// Options of `select_seams()`.
struct Seam_options
{
  /// The largest predicted \f$L_2\f$ stretch of a disk; at least 1. With infinity, the surface is only cut to disks.
  double stretch_bound = 1.1;

  /// The largest number of terminals of each part: vertices that seams lead to because of their scale. At least 0.
  int maximum_number_of_terminals = 100;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_OPTIONS_H
