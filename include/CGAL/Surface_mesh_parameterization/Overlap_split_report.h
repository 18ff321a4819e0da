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
/// The report of `split_overlaps()`.
struct Overlap_split_report : Report
{
  std::size_t number_of_charts = 0; ///< The number of charts: connected pieces between given seams.
  std::size_t number_of_overlapping_charts = 0; ///< The number of charts whose maps were not injective.

  /// The number of faces that overlapped other faces of their chart. It may be too small if a chart has more than 64
  /// overlapping pairs for each face, because not all pairs are then examined.
  std::size_t number_of_overlapping_faces = 0;
  /// The number of connected pieces between all seams, each with an injective map.
  std::size_t number_of_pieces = 0;

  /// The length of the borders of the overlapping charts; a seam within a chart counts twice.
  double border_length = 0;
  double added_seam_length = 0; ///< The length of the added seams, each counted once.

  /// The relative growth of the borders: twice `added_seam_length` divided by `border_length`; 0 if nothing overlapped.
  double extra_seam = 0;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAP_SPLIT_REPORT_H
