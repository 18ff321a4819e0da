// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_SELECTION_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_SELECTION_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <cstddef>
#include <string>

/// \file Seam_selection_report.h

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `read_seam_selection()` and `write_seam_selection()` return. Like the `bool` of \cgal's functions for files, it
/// converts to `true` on success.
struct Seam_selection_report
{
  /// What is wrong with a file.
  enum Diagnosis
  {
    NOTHING_WRONG,       ///< Success.
    CANNOT_OPEN,         ///< The file cannot be opened.
    CANNOT_READ,         ///< Reading failed.
    CANNOT_WRITE,        ///< Writing failed, for example because the disk is full.
    TOO_FEW_LINES,       ///< There is no third line.
    NOT_A_NUMBER,        ///< A word is not a vertex number.
    NUMBER_OUT_OF_RANGE, ///< The mesh has no vertex of this number.
    ODD_COUNT,           ///< The last number is without a partner.
    NO_SUCH_EDGE         ///< There is no edge between two vertices.
  };

  Diagnosis diagnosis = NOTHING_WRONG; ///< What is wrong.
  std::string message;                 ///< A sentence that names file, line and number; empty on success.
  std::size_t line = 0;                ///< The line with the error, from 1; 0 if there is none.
  std::size_t element =
      0; ///< Which number of the line is wrong, from 1; 0 if there is none. It is the first of a pair.

  std::size_t number_of_seams = 0; ///< Pairs in the file that are seams.

  /// Pairs in the file that are border edges. They are not marked: a border edge is no seam.
  std::size_t number_of_border_edges = 0;

  /// returns whether reading or writing succeeded.
  explicit operator bool() const { return diagnosis == NOTHING_WRONG; }
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// returns the name of a diagnosis, such as `"NO_SUCH_EDGE"`.
///
/// \relates Seam_selection_report
inline std::string to_string(Seam_selection_report::Diagnosis diagnosis)
{
  switch(diagnosis) {
  case Seam_selection_report::NOTHING_WRONG:
    return "NOTHING_WRONG";
  case Seam_selection_report::CANNOT_OPEN:
    return "CANNOT_OPEN";
  case Seam_selection_report::CANNOT_READ:
    return "CANNOT_READ";
  case Seam_selection_report::CANNOT_WRITE:
    return "CANNOT_WRITE";
  case Seam_selection_report::TOO_FEW_LINES:
    return "TOO_FEW_LINES";
  case Seam_selection_report::NOT_A_NUMBER:
    return "NOT_A_NUMBER";
  case Seam_selection_report::NUMBER_OUT_OF_RANGE:
    return "NUMBER_OUT_OF_RANGE";
  case Seam_selection_report::ODD_COUNT:
    return "ODD_COUNT";
  case Seam_selection_report::NO_SUCH_EDGE:
    return "NO_SUCH_EDGE";
  }
  return "unknown";
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_SEAM_SELECTION_REPORT_H
