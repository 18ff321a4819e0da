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
/// What `pack_charts()` reports.
struct Packing_report : Report
{
  std::size_t number_of_faces = 0;  ///< The faces that have a chart.
  std::size_t number_of_charts = 0; ///< The charts that have a face.

  /// The sum of the areas of all triangles, where the unit square has area 1. What overlaps within a chart counts each
  /// time.
  double covered_share = 0;

  /// How many texels a unit of length of the surface has along it, where the weight is 1 and the map is isometric.
  double texels_per_length = 0;

  std::size_t number_of_turned_charts = 0; ///< The charts that were tried in all directions, and not in four.

  /// The charts that were not tried in rows of texels where the one before, of about the same size, had no place.
  std::size_t number_of_small_charts = 0;

  /// The charts that would be smaller than a sixteenth of a texel. They were enlarged to that, so that they do not
  /// vanish when coordinates are rounded.
  std::size_t number_of_enlarged_charts = 0;

  std::size_t number_of_attempts = 0; ///< How many scales were tried.
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_REPORT_H
