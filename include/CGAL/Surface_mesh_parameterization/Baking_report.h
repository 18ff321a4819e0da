// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <cstddef>
#include <string>

/// \file Baking_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `bake_surface()` reports. Like the reports on files, it converts to `true` on success.
struct Baking_report
{
  /// What went wrong. In all cases but the first, nothing is baked.
  enum Diagnosis
  {
    NOTHING_WRONG,    ///< Every texel of a chart and of its gutter has a value.
    EMPTY_MESH,       ///< No face of the simple surface has a chart.
    NOT_TRIANGULATED, ///< A face of the simple surface is not a triangle.
    NON_FINITE_POINT, ///< A coordinate of a point of the simple surface is not a number, or above \f$10^{37}\f$.
    NO_TEXTURE_COORDINATES, ///< A face has texture coordinates that are infinite or not a number, or the coordinates of all faces have no area.
    OUTSIDE_SQUARE,         ///< A texture coordinate is below 0 or above 1.
    EMPTY_FINE_MESH,        ///< The fine surface has no face with area.
    FINE_MESH_NOT_TRIANGULATED, ///< A face of the fine surface is not a triangle.
    WRONG_FINE_POINT, ///< A coordinate of a point of the fine surface is infinite, not a number, or too far from the simple surface.
    WRONG_NORMAL,     ///< A given normal of a vertex is zero, infinite, or not a number.
    WRONG_OPTION,     ///< The resolution, the gutter, or the largest distance is out of its range.
    TOO_LARGE         ///< A surface has more triangles than 32-bit numbers allow.
  };

  Diagnosis diagnosis = NOTHING_WRONG; ///< What went wrong.
  std::string message; ///< A sentence that says what went wrong and where; empty if nothing is wrong.

  /// The texels that a chart touches. Each got its values from the fine surface.
  std::size_t number_of_chart_texels = 0;

  /// The texels around the charts that got the values of the nearest texel of a chart.
  std::size_t number_of_gutter_texels = 0;

  /// The texels of charts whose ray met no face of the fine surface that looks along the ray, but one that looks against it. Its normal was
  /// turned around.
  std::size_t number_of_back_faces = 0;

  /// The texels of charts whose ray met nothing. They got the values at the closest point of the fine surface.
  std::size_t number_of_missed_rays = 0;

  double ray_length = 0; ///< How far rays went to both sides, in units of the surface.

  /// The largest distance between a point of the simple surface and the point that was found for it, in units of the surface.
  double largest_distance = 0;

  double mean_distance = 0; ///< The mean of these distances.

  /// returns whether the textures are baked.
  explicit operator bool() const { return diagnosis == NOTHING_WRONG; }

  /// returns the number of the texels of charts whose ray met a face that looks along it.
  std::size_t number_of_front_faces() const
  {
    return number_of_chart_texels - number_of_back_faces - number_of_missed_rays;
  }
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a diagnosis, such as `"OUTSIDE_SQUARE"`.
///
/// \relates Baking_report
inline std::string to_string(Baking_report::Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Baking_report::NOTHING_WRONG:
    return "NOTHING_WRONG";
  case Baking_report::EMPTY_MESH:
    return "EMPTY_MESH";
  case Baking_report::NOT_TRIANGULATED:
    return "NOT_TRIANGULATED";
  case Baking_report::NON_FINITE_POINT:
    return "NON_FINITE_POINT";
  case Baking_report::NO_TEXTURE_COORDINATES:
    return "NO_TEXTURE_COORDINATES";
  case Baking_report::OUTSIDE_SQUARE:
    return "OUTSIDE_SQUARE";
  case Baking_report::EMPTY_FINE_MESH:
    return "EMPTY_FINE_MESH";
  case Baking_report::FINE_MESH_NOT_TRIANGULATED:
    return "FINE_MESH_NOT_TRIANGULATED";
  case Baking_report::WRONG_FINE_POINT:
    return "WRONG_FINE_POINT";
  case Baking_report::WRONG_NORMAL:
    return "WRONG_NORMAL";
  case Baking_report::WRONG_OPTION:
    return "WRONG_OPTION";
  case Baking_report::TOO_LARGE:
    return "TOO_LARGE";
  }
  return "unknown";
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_BAKING_REPORT_H
