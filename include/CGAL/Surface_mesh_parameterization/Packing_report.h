// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <cstddef>
#include <string>

/// \file Packing_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `pack_charts()` reports. Like the reports on files, it converts to `true` on success.
struct Packing_report
{
  /// What went wrong. In all cases but the first, the coordinates are unchanged.
  enum Diagnosis
  {
    NOTHING_WRONG,         ///< No two charts share a texel with its gutter, which is certified.
    EMPTY_MESH,            ///< No face has a chart.
    NOT_TRIANGULATED,      ///< A face is not a triangle.
    NON_FINITE_POINT,      ///< A coordinate of a point in space is infinite or not a number.
    NON_FINITE_COORDINATE, ///< A coordinate in the plane is infinite or not a number.
    WRONG_WEIGHT,          ///< A face has a weight that is negative or not finite.
    WRONG_OPTION,          ///< The resolution, the gutter, or the number of rotations is out of its range.
    DEGENERATE_CHART, ///< A chart has no area in the plane up to rounding, or is too large to compute it.
    NO_AREA,          ///< No face has area in space, or a weight that is not 0.
    TOO_MANY_CHARTS, ///< The charts and their gutters do not fit into the square, however small the charts are.
    NOT_CERTIFIED, ///< The coordinates could not be certified, because the number type of the map rounds too coarsely.
    TOO_LARGE ///< The surface has more triangles than 32-bit numbers allow.
  };

  Diagnosis diagnosis = NOTHING_WRONG; ///< What went wrong.
  std::string message; ///< A sentence that says what went wrong and where; empty if nothing is wrong.

  std::size_t number_of_faces = 0;  ///< The faces that have a chart.
  std::size_t number_of_charts = 0; ///< The charts that have a face.

  /// The sum of the areas of all triangles, where the unit square has area 1. What overlaps within a chart counts each time.
  double covered_share = 0;

  /// How many texels a unit of length of the surface has along it, where the weight is 1 and the map is isometric.
  double texels_per_length = 0;

  std::size_t number_of_turned_charts = 0; ///< The charts that were tried in all directions, and not in four.

  /// The charts that were not tried in rows of texels where the one before, of about the same size, had no place.
  std::size_t number_of_small_charts = 0;

  /// The charts that would be smaller than a sixteenth of a texel. They were enlarged to that, so that they do not vanish when coordinates
  /// are rounded.
  std::size_t number_of_enlarged_charts = 0;

  std::size_t number_of_attempts = 0; ///< How many scales were tried.

  /// returns whether the charts are packed.
  explicit operator bool() const { return diagnosis == NOTHING_WRONG; }
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a diagnosis, such as `"TOO_MANY_CHARTS"`.
///
/// \relates Packing_report
inline std::string to_string(Packing_report::Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Packing_report::NOTHING_WRONG:
    return "NOTHING_WRONG";
  case Packing_report::EMPTY_MESH:
    return "EMPTY_MESH";
  case Packing_report::NOT_TRIANGULATED:
    return "NOT_TRIANGULATED";
  case Packing_report::NON_FINITE_POINT:
    return "NON_FINITE_POINT";
  case Packing_report::NON_FINITE_COORDINATE:
    return "NON_FINITE_COORDINATE";
  case Packing_report::WRONG_WEIGHT:
    return "WRONG_WEIGHT";
  case Packing_report::WRONG_OPTION:
    return "WRONG_OPTION";
  case Packing_report::DEGENERATE_CHART:
    return "DEGENERATE_CHART";
  case Packing_report::NO_AREA:
    return "NO_AREA";
  case Packing_report::TOO_MANY_CHARTS:
    return "TOO_MANY_CHARTS";
  case Packing_report::NOT_CERTIFIED:
    return "NOT_CERTIFIED";
  case Packing_report::TOO_LARGE:
    return "TOO_LARGE";
  }
  return "unknown";
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_PACKING_REPORT_H
