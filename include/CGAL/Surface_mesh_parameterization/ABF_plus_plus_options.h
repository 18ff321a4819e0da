// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_OPTIONS_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_visitor.h>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// The options of `ABF_plus_plus_parameterizer_3`. The default values suit every mesh we know of; none
/// depends on the scale or the resolution of the mesh.
struct ABF_plus_plus_options : Flattening_options
{
  /// How the second derivatives of the constraints enter a step of the angle solver.
  enum Step_type
  {
    NEWTON,                         ///< Kept: the Hessian stays diagonal, and convergence is quadratic.
    SEQUENTIAL_LINEARLY_CONSTRAINED ///< Dropped, as in Section 3.1 of \cgalCite{cgal:slmb-abf-05}.
  };

  /// How the linear system of a step (Equation 16 of \cgalCite{cgal:slmb-abf-05}) is solved.
  enum Linear_solver
  {
    ITERATIVE, ///< By conjugate gradients, as exactly as the next step asks for. The factors of two scalar matrices, a
    ///< quarter of the system each, precondition several steps; the counterpart of lower precision of the solver traits
    ///< computes them (`Low_precision_solver_traits`) where that suffices. Where conjugate gradients are slow the system is factored.
    ///< Traits without factorization solve each system as a whole.
    DIRECT ///< As a whole, as in the paper.
  };

  /// How planar coordinates are computed from planar angles.
  enum Layout_type
  {
    AUTOMATIC_LAYOUT,    ///< `EXACT_LAYOUT` where the angles fit together, else `LEAST_SQUARES_LAYOUT`.
    EXACT_LAYOUT,        ///< Walk along the border, then one Laplace equation. For charts with one border.
    LEAST_SQUARES_LAYOUT ///< Equations 19 to 21 of \cgalCite{cgal:slmb-abf-05}.
  };

  /// Largest violation of a constraint at a vertex that is accepted, in radians; at least 1e-14. That of the reconstruction
  /// constraint is the logarithm of a ratio of lengths. The layout closes what is left: with the default value, measures
  /// of distortion have four or more right digits.
  double tolerance = 1e-5;

  /// The solver goes on until it takes a step that promised to lower the energy by less than this part of it; positive. As
  /// Newton's method converges quadratically, what is left then is far less.
  double energy_tolerance = 1e-4;

  /// Largest number of Newton steps of each strategy. What needs more is laid out as far as it came, and accepted
  /// only if no triangle is flipped.
  int max_iterations = 100;

  Step_type step = NEWTON; ///< Treatment of the constraints' second derivatives.

  Linear_solver linear_solver = ITERATIVE; ///< Way to solve the linear system of a step.

  Layout_type layout = AUTOMATIC_LAYOUT; ///< Way from angles to coordinates.

  /// Whether fallback strategies are tried where Newton's method from the target angles gives no valid map; which of them
  /// did is in the report, `ABF_plus_plus_report::strategy`. Otherwise that is an error.
  bool fallbacks = true;
};

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_ABF_PLUS_PLUS_OPTIONS_H
