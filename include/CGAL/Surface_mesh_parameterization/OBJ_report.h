// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_OBJ_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_OBJ_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <cstddef>

/// \file OBJ_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `IO::read_OBJ()` and `IO::write_OBJ()` return. Like the `bool` of \cgal's functions for files, it converts to
/// `true` on success.
struct OBJ_report : Report
{
  /// The line with the error, from 1; 0 if there is none. Of a line that is continued, it is the first.
  std::size_t line = 0;

  std::size_t number_of_faces_without_coordinates =
      0; ///< The faces that have no texture coordinates in the file.
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_OBJ_REPORT_H
