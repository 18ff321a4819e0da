// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SUPERLU_OPTIONS_H
#define CGAL_SUPERLU_OPTIONS_H

namespace CGAL {

/*!
\ingroup PkgSolverInterfaceLS

The options of `SuperLU_solver_traits`. The default values suit matrices from triangle meshes. The widths change the
speed of SuperLU, and only the last digits of results.

\sa `CGAL::SuperLU_solver_traits<FT>`
*/
struct SuperLU_options
{
  /// How a factorization is checked before it is used.
  enum Check
  {
    /// A matrix that is singular up to rounding errors is refused. A matrix that is not definite is factored with
    /// partial pivoting, after its rows and columns were scaled. The backward error of each solution is small.
    /// Iterative refinement ensures this if necessary.
    ACCURACY,
    /// Only a symmetric matrix is factored. All its pivots must be on the diagonal, have the sign of the diagonal, and
    /// be larger than \f$ 16 \varepsilon\f$ times the entry of the matrix there (\f$ \varepsilon\f$ is the precision of
    /// the number type). Any other matrix is refused. The factors are then those of a definite matrix. Solutions are
    /// finite, but their accuracy is not guaranteed. Use this check for factors that precondition an iterative
    /// solution, which has a check of its own.
    PIVOTS
  };

  /// How a factorization is checked.
  Check check = ACCURACY;

  /// The number of columns that SuperLU treats at once, at least 1; 0 means an automatic choice. SuperLU has an upper
  /// limit, 20 by default. Larger values have the effect of this limit.
  int panel_width = 0;

  /// The largest number of columns of a subtree of the elimination tree that becomes one dense block, at least 1; 0
  /// means an automatic choice. SuperLU has an upper limit, 20 by default. Larger values have the effect of this
  /// limit.
  int relax = 0;
};

} // namespace CGAL

#endif // CGAL_SUPERLU_OPTIONS_H
