// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <cstddef>
#include <string>

/// \file Baking_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `bake_surface()` reports.
struct Baking_report : Report
{
  /// The texels that a chart touches. Each got its values from the fine surface.
  std::size_t number_of_chart_texels = 0;

  /// The texels around the charts that got the values of the nearest texel of a chart.
  std::size_t number_of_gutter_texels = 0;

  /// The texels of charts whose ray met no face of the fine surface that looks along the ray, but one that looks
  /// against it. Its normal was turned around.
  std::size_t number_of_back_faces = 0;

  /// The texels of charts whose ray met nothing. They got the values at the closest point of the fine surface.
  std::size_t number_of_missed_rays = 0;

  double ray_length = 0; ///< How far rays went to both sides, in units of the surface.

  /// The largest distance between a point of the simple surface and the point that was found for it, in units of the
  /// surface.
  double largest_distance = 0;

  double mean_distance = 0; ///< The mean of these distances.

  /// returns the number of the texels of charts whose ray met a face that looks along it.
  std::size_t number_of_front_faces() const
  {
    return number_of_chart_texels - number_of_back_faces - number_of_missed_rays;
  }
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_REPORT_H
