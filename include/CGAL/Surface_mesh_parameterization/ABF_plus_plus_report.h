// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_REPORT_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>

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
  /// Fraction of the full step that was taken. It is above 1 where full steps converge slowly.
  double step_length = 0;
  int linear_iterations = 0; ///< Steps of conjugate gradients.
  /// Matrices factored: one by the direct solver, two by the iterative one at first. Where slivers, steep cones or
  /// holes are, the iterative solver factors another one, which is small, in each step.
  int factorizations = 0;
  int repeated_factorizations = 0; ///< Of these, those that the counterpart of lower precision
  ///< (`Low_precision_solver_traits`) refused, and that the solver traits themselves repeated.
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The report of the last run of `ABF_plus_plus_parameterizer_3`.
struct ABF_plus_plus_report : Flattening_report
{
  /// The ways to a valid map, in the order in which they are tried.
  enum Strategy
  {
    FROM_TARGET_ANGLES, ///< Newton's method from the target angles.
    RAISED_BARRIER,    ///< The same with a higher barrier, and from there with the given barrier if possible.
    FROM_SOFT_PATCHES, ///< Newton's method from the angles of the next one (`Flattening_options::SOLVE`).
    SOFT_PATCHES,      ///< Newton's method from the target angles, with the holes filled.
    STIFF_PATCHES,     ///< The same with fillings of the full weight of the triangles around them.
    FROM_PROGRESSIVE_EMBEDDING, ///< Newton's method from the angles of a progressive embedding, which satisfy all
    ///< constraints: the surface is simplified to one triangle, and all vertices are inserted again where their
    ///< triangles are valid.
    PROGRESSIVE_EMBEDDING, ///< That map itself, improved by local descent on the energy.

    /// The injective map of the hierarchical method, polished, where the direct method's own overlaps itself
    /// (`Flattening_options::injective`).
    INJECTIVE_DESCENT
  };

  /// A strategy that did not give a valid map.
  struct Failed_strategy
  {
    Strategy strategy;   ///< The strategy.
    Diagnosis status;    ///< Why it failed.
    std::string message; ///< The reason as a sentence.
    int iterations;      ///< Newton steps taken.
  };

  /// The layout that gave the coordinates.
  enum Layout
  {
    NO_LAYOUT,    ///< None, because the run ended before.
    EXACT,        ///< `ABF_plus_plus_options::EXACT_LAYOUT`.
    LEAST_SQUARES ///< `ABF_plus_plus_options::LEAST_SQUARES_LAYOUT`.
  };

  Strategy strategy = FROM_TARGET_ANGLES;         ///< The strategy that gave the result, or was tried last.
  std::vector<Failed_strategy> failed_strategies; ///< The strategies that failed before.

  bool converged = false;                ///< Whether both tolerances were met.
  int iterations = 0;                    ///< Newton steps taken.
  double energy = 0;                     ///< Energy of the planar angles, including the barrier.
  double constraint_residual = 0;        ///< Largest violation of a constraint at a vertex, in radians.
  std::vector<ABF_plus_plus_step> steps; ///< All steps.

  /// The layout that gave the coordinates; none if they are those of an embedding.
  Layout layout = NO_LAYOUT;
  bool layout_repeated = false; ///< Whether low precision was not enough for the exact layout.

  /// Largest gap in a border that the exact layout closed, relative to the border's length.
  double closure = 0;

  /// Largest difference between the logarithms of the lengths of both sides of an edge on a seam (`Seam_mesh`); 0
  /// without seams.
  double largest_seam_jump = 0;
  /// Largest difference from \f$2\pi\f$ of the sum of the planar angles at a vertex in the middle of a seam, in
  /// radians: by so much one side of the seam turns differently from the other side. Vertices whose sums are prescribed
  /// or marked as free are not counted.
  double largest_seam_turn = 0;

  /// Vertices with a prescribed angle, of the surface before the cut if seams have equal lengths.
  int prescribed_angles = 0;
  /// Largest difference of a prescribed angle from that of the map, in radians.
  double largest_angle_error = 0;
  /// Largest distance of a vertex from the straight side that it is prescribed to be on: from the line through the ends
  /// of the side, relative to the distance of these ends.
  double side_deviation = 0;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_REPORT_H
