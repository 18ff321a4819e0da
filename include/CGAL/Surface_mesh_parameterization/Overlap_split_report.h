// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAP_SPLIT_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAP_SPLIT_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <cstddef>
#include <string>

/// \file Overlap_split_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `split_overlaps()` reports.
struct Overlap_split_report : Report
{
  std::size_t number_of_charts = 0; ///< The connected parts of the surface without the seams that were given.
  std::size_t number_of_overlapping_charts = 0; ///< Those whose maps were not injective.

  /// The faces that overlapped others of their chart. Beyond 64 pairs of such faces for each face of a chart, not all
  /// pairs are looked at.
  std::size_t number_of_overlapping_faces = 0;
  /// The connected parts of the surface without all seams, each with an injective map.
  std::size_t number_of_pieces = 0;

  /// The length of the borders of the overlapping charts; a seam within a chart counts twice.
  double border_length = 0;
  double added_seam_length = 0; ///< The length of the seams that were added, each counted once.

  /// By which share the borders became longer: twice `added_seam_length` divided by `border_length`; 0 if nothing
  /// overlapped.
  double extra_seam = 0;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAP_SPLIT_REPORT_H
