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
/// One step of the angle solver.
struct ABF_plus_plus_step
{
  int iteration = 0;              ///< Number of the step, from 1.
  double energy = 0;              ///< Energy after the step.
  double constraint_residual = 0; ///< Largest violation of a constraint after the step, in radians.
  double predicted_decrease = 0;  ///< Decrease of the energy that the step's quadratic model promised.
  /// Fraction of the full step that was taken. It is above 1 if full steps converge slowly.
  double step_length = 0;
  int linear_iterations = 0; ///< Steps of conjugate gradients.
  /// Number of matrices that were factored: one by the direct solver; two by the iterative solver in the first step. If
  /// there are slivers, steep cones or holes, the iterative solver factors one more small matrix in each step.
  int factorizations = 0;
  /// Number of factorizations that the solver traits repeated, because the counterpart of lower precision
  /// (`Low_precision_solver_traits`) failed.
  int repeated_factorizations = 0;
};

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The report of the last run of `ABF_plus_plus_parameterizer_3`.
struct ABF_plus_plus_report : Flattening_report
{
  /// The ways to a valid map, in the order in which they are tried.
  enum Strategy
  {
    FROM_LAST_ANGLES, ///< Newton's method from the angles of the last call (`ABF_plus_plus_options::warm_start`).
    FROM_TARGET_ANGLES, ///< Newton's method from the target angles.

    /// The same with a higher barrier, and then with the given barrier from the angles found, if possible.
    RAISED_BARRIER,
    FROM_SOFT_PATCHES, ///< Newton's method from the angles of `SOFT_PATCHES` (`Flattening_options::SOLVE`).
    SOFT_PATCHES,      ///< Newton's method from the target angles, with the holes filled.
    STIFF_PATCHES,     ///< The same; the fillings have the full weight of the triangles around them.
    FROM_PROGRESSIVE_EMBEDDING, ///< Newton's method from the angles of a progressive embedding, which satisfy all
    ///< constraints: the surface is simplified to one triangle, and all vertices are inserted again where their
    ///< triangles are valid.
    PROGRESSIVE_EMBEDDING, ///< The progressive embedding itself, improved by local descent on the energy.

    /// The polished injective map of the hierarchical method, if the map of the direct method overlaps itself
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
  std::vector<Failed_strategy> failed_strategies; ///< The strategies that failed before this one.

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

  /// Largest difference between the logarithms of the lengths of both sides of a seam edge; 0 without seams.
  double largest_seam_jump = 0;
  /// Largest difference between \f$2\pi\f$ and the sum of planar angles at a vertex in the middle of a seam, in
  /// radians. This is the difference between the turns of both sides of the seam. Vertices with a prescribed or free
  /// sum do not count.
  double largest_seam_turn = 0;

  /// Number of vertices with a prescribed angle. If seams have equal lengths, these are vertices of the surface before
  /// the cut.
  int prescribed_angles = 0;
  /// Largest difference between a prescribed angle and the angle in the map, in radians.
  double largest_angle_error = 0;
  /// Largest distance between a vertex and the straight side that it should be on: the distance from the line through
  /// the ends of the side, divided by the length of the side.
  double side_deviation = 0;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_REPORT_H
