// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAP_SPLIT_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAP_SPLIT_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <cstddef>
#include <string>

/// \file Overlap_split_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `split_overlaps()` reports. Like the reports on files, it converts to `true` on success.
struct Overlap_split_report
{
  /// What went wrong. In all cases but the first, seams and charts are unchanged.
  enum Diagnosis
  {
    NOTHING_WRONG,         ///< The map of each piece is certified to be injective.
    EMPTY_MESH,            ///< The mesh has no faces.
    NOT_TRIANGULATED,      ///< A face is not a triangle.
    NON_FINITE_POINT,      ///< A coordinate of a point in space is infinite or not a number.
    NON_FINITE_COORDINATE, ///< A coordinate in the plane is infinite or not a number.
    INCONSISTENT_COORDINATES, ///< The coordinates of halfedges differ within a chart at a vertex, and no seam is between them.
    FLIPPED_FACE,   ///< A face is not positively oriented in the plane. Cuts do not help.
    WRONG_WEIGHT,   ///< An edge has a negative weight, or one that is not a number.
    NO_CUT_ALLOWED, ///< The edges that may become seams leave no way.
    NOT_CERTIFIED,  ///< The map of a piece could not be certified to be injective.
    TOO_LARGE       ///< The surface has more triangles than 32-bit numbers allow.
  };

  Diagnosis diagnosis = NOTHING_WRONG; ///< What went wrong.
  std::string message; ///< A sentence that says what went wrong and where; empty if nothing is wrong.

  std::size_t number_of_charts = 0; ///< The connected parts of the surface without the seams that were given.
  std::size_t number_of_overlapping_charts = 0; ///< Those whose maps were not injective.

  /// The faces that overlapped others of their chart. Beyond 64 pairs of such faces for each face of a chart, not all pairs are looked at.
  std::size_t number_of_overlapping_faces = 0;
  std::size_t number_of_pieces =
      0; ///< The connected parts of the surface without all seams, each with an injective map.

  double border_length =
      0; ///< The length of the borders of the overlapping charts; a seam within a chart counts twice.
  double added_seam_length = 0; ///< The length of the seams that were added, each counted once.

  /// By which share the borders became longer: twice `added_seam_length` divided by `border_length`; 0 if nothing overlapped.
  double extra_seam = 0;

  /// returns whether the maps of all pieces are injective.
  explicit operator bool() const { return diagnosis == NOTHING_WRONG; }
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a diagnosis, such as `"FLIPPED_FACE"`.
///
/// \relates Overlap_split_report
inline std::string to_string(Overlap_split_report::Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Overlap_split_report::NOTHING_WRONG:
    return "NOTHING_WRONG";
  case Overlap_split_report::EMPTY_MESH:
    return "EMPTY_MESH";
  case Overlap_split_report::NOT_TRIANGULATED:
    return "NOT_TRIANGULATED";
  case Overlap_split_report::NON_FINITE_POINT:
    return "NON_FINITE_POINT";
  case Overlap_split_report::NON_FINITE_COORDINATE:
    return "NON_FINITE_COORDINATE";
  case Overlap_split_report::INCONSISTENT_COORDINATES:
    return "INCONSISTENT_COORDINATES";
  case Overlap_split_report::FLIPPED_FACE:
    return "FLIPPED_FACE";
  case Overlap_split_report::WRONG_WEIGHT:
    return "WRONG_WEIGHT";
  case Overlap_split_report::NO_CUT_ALLOWED:
    return "NO_CUT_ALLOWED";
  case Overlap_split_report::NOT_CERTIFIED:
    return "NOT_CERTIFIED";
  case Overlap_split_report::TOO_LARGE:
    return "TOO_LARGE";
  }
  return "unknown";
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_OVERLAP_SPLIT_REPORT_H
