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
/// The report of `cut_to_disks()`, `select_seams()` and `shorten_seams()`.
struct Seam_report : Report
{
  std::size_t number_of_components = 0; ///< the number of connected components
  std::size_t number_of_disks = 0;      ///< the number of disks between the seams

  /// the number of vertices that seams lead to: for `select_seams()` because of their scale, for `cut_to_disks()`
  /// because they were given
  std::size_t number_of_terminals = 0;
  double seam_length = 0;          ///< the length of all seams, each counted once
  double relative_seam_length = 0; ///< `seam_length`, divided by the square root of the area
  double predicted_stretch = 1; ///< the largest \f$L_2\f$ stretch that `select_seams()` predicts for a disk
  bool bound_reached = true;    ///< whether the predicted stretch is at most the bound
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_REPORT_H
