// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <cstddef>
#include <string>

/// \file Seam_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What the functions report that cut a surface open along seams: `cut_to_disks()`, `select_seams()`, and
/// `shorten_seams()`.
struct Seam_report : Report
{
  std::size_t number_of_components = 0; ///< the connected components of the surface
  std::size_t number_of_disks = 0;      ///< the connected components of the surface without its seams

  /// the vertices that seams were led to: by `select_seams()` because of their scale, by `cut_to_disks()` because they
  /// were given
  std::size_t number_of_terminals = 0;
  double seam_length = 0;          ///< the length of all seams, each counted once
  double relative_seam_length = 0; ///< the same, divided by the square root of the area of the surface
  double predicted_stretch = 1; ///< the largest \f$L_2\f$ stretch of all disks that `select_seams()` expects
  bool bound_reached = true;    ///< whether that is at most the bound
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_REPORT_H
