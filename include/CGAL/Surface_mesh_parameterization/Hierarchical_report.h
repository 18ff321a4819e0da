// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>

#include <limits>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The report of the last run of `Hierarchical_parameterizer_3`.
struct Hierarchical_report : Flattening_report
{
  /// Where the refinement started.
  enum Start
  {
    COARSE_PARAMETERIZER,  ///< The coarse chart, flattened by the coarse parameterizer.
    PROGRESSIVE_EMBEDDING, ///< A single triangle, because no coarse chart could be flattened or refined.
    TUTTE_MAP              ///< Tutte's map of the coarse chart to a circle (`Flattening_options::injective`).
  };

  int levels = 0;                     ///< Levels of collapses above the coarse chart.
  int coarse_vertices = 0;            ///< Vertices of the coarse chart.
  int coarse_triangles = 0;           ///< Triangles of the coarse chart.
  Start start = COARSE_PARAMETERIZER; ///< Where the refinement started.
  bool holes_filled = false; ///< Whether holes were filled, by request or because they could not be solved.
  int retries = 0;           ///< Number of coarse charts that could not be flattened.
  int kernel_insertions = 0; ///< Number of vertices that were inserted at the centre of a kernel.
  int moves = 0;             ///< Number of vertices that relaxation moved.
  int rejected_moves = 0;    ///< Number of vertices that relaxation did not move.
  int angle_sweeps = 0;      ///< Number of final sweeps.

  /// Energy of the planar angles, including the barrier. It is computed only for final sweeps and polishing; otherwise
  /// NaN.
  double energy = (std::numeric_limits<double>::quiet_NaN)();

  /// Whether polishing succeeded: the result is then that of the direct solver. For injective maps: whether Newton's
  /// method converged; if not, the map has the lowest energy that was reached.
  bool polished = false;
  int polish_iterations = 0;      ///< Newton steps of polishing.
  double constraint_residual = 0; ///< Largest violation of a constraint by the polished angles, in radians.
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_HIERARCHICAL_REPORT_H
