// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// One step of the angle solver, as reported.
struct ABF_plus_plus_step
{
  int iteration = 0;              ///< Number of the step, from 1.
  double energy = 0;              ///< Energy after the step.
  double constraint_residual = 0; ///< Largest violation of a constraint after the step, in radians.
  double predicted_decrease = 0;  ///< Decrease of the energy that the step's quadratic model promised.
  double step_length = 0;         ///< Part of the full step that was taken, in (0, 1].
  int linear_iterations = 0;      ///< Steps of conjugate gradients.
  int factorizations = 0; ///< Matrices factored: two by the iterative solver at first, one by the direct one.
  int repeated_factorizations = 0; ///< Of these, those that the counterpart of lower precision
  ///< (`Low_precision_solver_traits`) refused, and that the solver traits themselves did again.
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The report of the last run of `ABF_plus_plus_parameterizer_3`.
struct ABF_plus_plus_report
{
  /// What is wrong with an input, or kept a run from its end.
  enum Diagnosis
  {
    NOTHING_WRONG,    ///< The run succeeded.
    EMPTY_MESH,       ///< There is no face at the given border.
    NOT_ON_BORDER,    ///< The given halfedge is null or not on a border.
    NOT_TRIANGULATED, ///< A face is not a triangle.
    NON_FINITE_POINT, ///< A coordinate is infinite or not a number.
    TOO_LARGE,        ///< More than 238 million triangles.
    PINCHED_VERTEX,   ///< The surface is not a manifold at a vertex.
    SEVERAL_BORDERS,  ///< The chart has holes, and `ABF_plus_plus_options::allow_holes` is `false`.
    HANDLES,          ///< The chart has handles: no cutting along the border makes it a disk.
    PARALLEL_EDGES,   ///< Two edges have the same vertices, or an edge is a loop: no planar drawing exists.
    LINEAR_SYSTEM_FAILED, ///< The solver traits failed.
    NO_CONVERGENCE,    ///< The constraints could not be met, and the resulting layout has flipped triangles.
    WRONG_OPTION,      ///< An option is out of its range.
    WRONG_LAYOUT,      ///< The exact layout was asked for and does not apply.
    FLIPPED_TRIANGLES, ///< The layout has flipped triangles although the angles are right.
    PRECISION_EXCEEDED, ///< There is a valid map, but the coordinates' number type does not hold the one found.
    CANCELLED           ///< A visitor stopped the computation.
  };

  /// The ways to a valid map, in the order in which they are tried.
  enum Rung
  {
    FROM_TARGET_ANGLES, ///< Newton's method from the target angles.
    RAISED_BARRIER, ///< The same with a higher barrier, and from there with the one asked for, if that is possible.
    FROM_VALID_MAP, ///< Newton's method from the angles of a valid map, which fulfil all constraints.
    VALID_MAP       ///< That valid map itself: it is as good as local descent on the energy made it.
  };

  /// A rung that gave no valid map.
  struct Failed_rung
  {
    Rung rung;           ///< Which one.
    Diagnosis diagnosis; ///< What was wrong.
    std::string message; ///< The same as a sentence.
    int iterations;      ///< Newton steps taken.
  };

  /// Which of the layouts gave the coordinates.
  enum Layout
  {
    NO_LAYOUT,    ///< None: the run ended before.
    EXACT,        ///< `ABF_plus_plus_options::EXACT_LAYOUT`.
    LEAST_SQUARES ///< `ABF_plus_plus_options::LEAST_SQUARES_LAYOUT`.
  };

  /// Wall clock time of each stage, in seconds.
  struct Seconds
  {
    double read = 0;    ///< From the mesh to flat arrays, and the check of the input.
    double targets = 0; ///< Target angles.
    double angles = 0;  ///< The nonlinear solver.
    double layout = 0;  ///< From angles to coordinates.
    double certify = 0; ///< Exact check of the orientations.
    double write = 0;   ///< Into the caller's property map.
    double total() const
    {
      return read + targets + angles + layout + certify + write;
    } ///< Sum of the stages.
  };

  Error_code status = OK;              ///< What `parameterize()` returned.
  Diagnosis diagnosis = NOTHING_WRONG; ///< What is wrong.
  std::string message;                 ///< The same as a sentence that names the place; empty on success.

  int vertices = 0;  ///< Vertices of the chart.
  int triangles = 0; ///< Triangles of the chart.
  int borders = 0;   ///< Border cycles of the chart.

  Rung rung = FROM_TARGET_ANGLES;        ///< What gave the result, or was tried last.
  std::vector<Failed_rung> failed_rungs; ///< What failed before.

  bool converged = false;                ///< Whether both tolerances were met.
  int iterations = 0;                    ///< Newton steps taken.
  double energy = 0;                     ///< Energy of the planar angles, the barrier included.
  double constraint_residual = 0;        ///< Largest violation of a constraint at a vertex, in radians.
  std::vector<ABF_plus_plus_step> steps; ///< All steps.

  Layout layout = NO_LAYOUT; ///< The layout that gave the coordinates; none if they are those of a valid map.
  bool layout_repeated = false; ///< Whether low precision was not enough for the exact layout.
  double closure = 0;           ///< Gap that the exact layout closed, relative to the border's length.
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

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_REPORT_H
