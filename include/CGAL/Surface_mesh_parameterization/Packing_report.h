// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <cstddef>
#include <string>

/// \file Packing_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The report of `pack_charts()`.
struct Packing_report : Report
{
  std::size_t number_of_faces = 0;  ///< The number of faces that have a chart.
  std::size_t number_of_charts = 0; ///< The number of charts that have a face.

  /// The sum of the areas of all triangles; the unit square has the area 1. Overlaps within a chart count several
  /// times.
  double covered_share = 0;

  /// The number of texels per unit of length on the surface, where the weight is 1 and the map is isometric.
  double texels_per_length = 0;

  /// The number of charts that were tried in all directions, not only in four.
  std::size_t number_of_turned_charts = 0;

  /// The number of charts that were not tried in rows of texels where the previous chart of about the same size did not
  /// fit.
  std::size_t number_of_small_charts = 0;

  /// The number of charts that were enlarged to a sixteenth of a texel, so that they do not vanish when coordinates are
  /// rounded.
  std::size_t number_of_enlarged_charts = 0;

  std::size_t number_of_attempts = 0; ///< The number of scales that were tried.
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_REPORT_H
