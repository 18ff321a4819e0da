// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <cstddef>
#include <string>

/// \file Seam_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What the functions report that cut a surface open along seams: `cut_to_disks()`, `select_seams()`, and `shorten_seams()`.
struct Seam_report
{
  /// What went wrong. In all cases but the first, the seams of the mesh are unchanged.
  enum Diagnosis
  {
    NOTHING_WRONG,    ///< The surface without its seams consists of disks.
    EMPTY_MESH,       ///< The mesh has no faces.
    NOT_TRIANGULATED, ///< A face is not a triangle.
    NON_FINITE_POINT, ///< A coordinate is infinite or not a number.
    WRONG_WEIGHT,     ///< An edge has a negative weight, or one that is not a number.
    WRONG_OPTION,     ///< A named parameter is out of its range.
    NO_CUT_ALLOWED, ///< A part of the surface cannot be cut to a disk along the edges that may become seams.
    LINEAR_SYSTEM_FAILED, ///< The linear solver failed.
    TOO_LARGE             ///< The surface has more triangles than 32-bit numbers allow.
  };

  Diagnosis diagnosis = NOTHING_WRONG; ///< what went wrong
  std::string message;                 ///< the same for people; empty if nothing is wrong

  std::size_t number_of_components = 0; ///< the connected components of the surface
  std::size_t number_of_disks = 0;      ///< the connected components of the surface without its seams
  std::size_t number_of_terminals =
      0; ///< the vertices that seams were led to: by `select_seams()` because of their scale, by `cut_to_disks()` because they were given
  double seam_length = 0;          ///< the length of all seams, each counted once
  double relative_seam_length = 0; ///< the same, divided by the square root of the area of the surface
  double predicted_stretch = 1; ///< the largest \f$L_2\f$ stretch of all disks that `select_seams()` expects
  bool bound_reached = true;    ///< whether that is at most the bound
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a diagnosis, such as `"NO_CUT_ALLOWED"`.
inline std::string to_string(Seam_report::Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Seam_report::NOTHING_WRONG:
    return "NOTHING_WRONG";
  case Seam_report::EMPTY_MESH:
    return "EMPTY_MESH";
  case Seam_report::NOT_TRIANGULATED:
    return "NOT_TRIANGULATED";
  case Seam_report::NON_FINITE_POINT:
    return "NON_FINITE_POINT";
  case Seam_report::WRONG_WEIGHT:
    return "WRONG_WEIGHT";
  case Seam_report::WRONG_OPTION:
    return "WRONG_OPTION";
  case Seam_report::NO_CUT_ALLOWED:
    return "NO_CUT_ALLOWED";
  case Seam_report::LINEAR_SYSTEM_FAILED:
    return "LINEAR_SYSTEM_FAILED";
  case Seam_report::TOO_LARGE:
    return "TOO_LARGE";
  }
  return "unknown";
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_REPORT_H
