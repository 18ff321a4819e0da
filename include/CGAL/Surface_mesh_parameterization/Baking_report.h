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
/// The report of `bake_surface()`.
struct Baking_report : Report
{
  /// The number of texels that a chart touches. Each got its values from the fine surface.
  std::size_t number_of_chart_texels = 0;

  /// The number of texels around the charts, which got the values of the nearest texel of a chart.
  std::size_t number_of_gutter_texels = 0;

  /// The number of texels of charts whose ray met only faces of the fine surface with a normal against the ray. The
  /// normal was reversed.
  std::size_t number_of_back_faces = 0;

  /// The number of texels of charts whose ray met nothing. They got the values of the closest point of the fine
  /// surface.
  std::size_t number_of_missed_rays = 0;

  double ray_length = 0; ///< The length of rays to each side, in units of the surface.

  /// The largest distance between a point of the simple surface and its point of the fine surface, in units of the
  /// surface.
  double largest_distance = 0;

  double mean_distance = 0; ///< The mean of these distances.

  /// returns the number of texels of charts whose ray met a face with a normal along the ray.
  std::size_t number_of_front_faces() const
  {
    return number_of_chart_texels - number_of_back_faces - number_of_missed_rays;
  }
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_REPORT_H
