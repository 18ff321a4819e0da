// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SUPERLU_OPTIONS_H
#define CGAL_SUPERLU_OPTIONS_H

namespace CGAL {

/*!
\ingroup PkgSolverInterfaceLS

The options of `SuperLU_solver_traits`. The default values suit matrices from triangle meshes. The widths change how fast
SuperLU is, and results in their last digits only.

\sa `CGAL::SuperLU_solver_traits<FT>`
*/
struct SuperLU_options
{
  /// What is checked of a factorization before it is used.
  enum Check
  {
    /// A matrix that is singular, but for rounding errors, is refused. A matrix that is not definite is factored with
    /// partial pivoting, after its rows and columns were scaled. The backward error of each solution is small, after iterative
    /// refinement where that is needed.
    ACCURACY,
    /// Only a symmetric matrix is factored whose pivots, all of them from the diagonal, have the sign of the diagonal, and are
    /// larger than \f$ 16 \varepsilon\f$ times the entry of the matrix there (\f$ \varepsilon\f$ is the precision of the number
    /// type); any other is refused. Then the factors are those of a definite matrix. Nothing is promised of the
    /// accuracy of solutions but that they are finite: this is for factors that precondition an iterative solution, which has a
    /// check of its own.
    PIVOTS
  };

  /// What is checked of a factorization.
  Check check = ACCURACY;

  /// The number of columns that SuperLU treats at once, from 1; 0 chooses one. More than SuperLU counts, by
  /// default 20, are as many as it counts.
  int panel_width = 0;

  /// The number of columns, from 1, that a subtree of the elimination tree may have to become one dense block; 0 chooses
  /// one. More than SuperLU counts, by default 20, are as many as it counts.
  int relax = 0;
};

} // namespace CGAL

#endif // CGAL_SUPERLU_OPTIONS_H
