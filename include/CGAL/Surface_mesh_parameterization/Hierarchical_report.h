// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>

#include <cstddef>
#include <string>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The report of the last run of `Hierarchical_parameterizer_3`.
struct Hierarchical_report
{
  /// From where the refinement started.
  enum Start
  {
    COARSE_PARAMETERIZER, ///< The coarse chart as the coarse parameterizer flattened it.
    WITHOUT_SOLVER        ///< A single triangle, as no coarse chart could be solved or refined.
  };

  /// Wall clock time of each stage, in seconds.
  struct Seconds
  {
    double read = 0;    ///< From the mesh to flat arrays, and the check of the input.
    double coarsen = 0; ///< Collapses.
    double solve = 0;   ///< The coarse parameterizer.
    double refine = 0;  ///< Insertion and relaxation.
    double polish = 0;  ///< The direct solver on the fine chart, if asked for.
    double certify = 0; ///< Scaling, and exact check of the orientations.
    double write = 0;   ///< Into the caller's property map.

    /// returns the sum of the stages.
    double total() const { return read + coarsen + solve + refine + polish + certify + write; }
  };

  Error_code status = OK; ///< What `parameterize()` returned.
  ABF_plus_plus_report::Diagnosis diagnosis = ABF_plus_plus_report::NOTHING_WRONG; ///< What is wrong.
  std::string message; ///< The same as a sentence that names the place; empty on success.

  int vertices = 0;  ///< Vertices of the chart.
  int triangles = 0; ///< Triangles of the chart.
  int borders = 0;   ///< Border cycles of the chart.

  int levels = 0;                     ///< Levels of collapses above the coarse chart.
  int coarse_vertices = 0;            ///< Vertices of the coarse chart.
  int coarse_triangles = 0;           ///< Triangles of the coarse chart.
  Start start = COARSE_PARAMETERIZER; ///< From where the refinement started.
  int retries = 0;                    ///< Coarse charts that could not be solved.
  int kernel_insertions =
      0;         ///< Vertices put into the centre of a kernel, as their weights gave an invalid place.
  int moves = 0; ///< Vertices moved by relaxation.
  int rejected_moves = 0; ///< Vertices that relaxation left where they were.

  bool polished = false;          ///< Whether the result is that of the direct solver.
  int polish_iterations = 0;      ///< Newton steps of the direct solver.
  double constraint_residual = 0; ///< Largest violation of a constraint by the polished angles, in radians.

  bool border_is_simple =
      false;              ///< Whether no two edges of the planar border touch but neighbours: with no flipped
                          ///< triangle, the map is then injective as a whole.
  double scale_range = 1; ///< Longest edge of the layout over its shortest one.
  int flipped_triangles = 0; ///< Triangles that are not positively oriented.
  double smallest_angle = 0; ///< Smallest angle of the planar triangulation, in radians.

  Seconds seconds; ///< Time of each stage.

  /// Largest resident size of the process until the end of the run, in bytes; 0 where the system does not tell.
  std::size_t peak_memory = 0;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_REPORT_H
