// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_SELECTION_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_SELECTION_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <cstddef>
#include <string>

/// \file Seam_selection_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The report of `read_seam_selection()` and `write_seam_selection()`. It converts to `true` on success, like the
/// `bool` of \cgal's functions for files.
struct Seam_selection_report : Report
{
  std::size_t line = 0; ///< The line with the error, from 1; 0 if there is none.

  /// The position of the wrong number in its line, from 1; 0 if there is none. For a pair, it is the first number.
  std::size_t element = 0;

  std::size_t number_of_seams = 0; ///< The number of pairs in the file that are seams.

  /// The number of pairs in the file that are border edges. They are not marked: a border edge is not a seam.
  std::size_t number_of_border_edges = 0;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_SELECTION_REPORT_H
