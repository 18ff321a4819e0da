// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// All thresholds for rounding errors, by number type, in one place. `SuperLU_factorization.h`, `SuperLU_input.h` and
// `SuperLU_scaling.h` decide by them what is singular, symmetric or accurate.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_TOLERANCES_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_TOLERANCES_H

#include <limits>

namespace CGAL {
namespace internal {

// Tolerances for rounding errors in the number type `FT`.
//
// - `asymmetry`: the difference of two entries (i, j) and (j, i), relative to the geometric mean of the diagonal
//   entries i and j. It must be below `good_residual`, because only one of the two is used.
// - `pivots_show_singularity`: whether a small pivot reveals a singular matrix. The last pivot of a singular
//   Laplacian with 200 000 rows is 1e-12 times its diagonal in double, but 0.01 times in float, where regular
//   matrices have smaller pivots.
// - `suspicious_pivot`: if so, a pivot is suspicious below this multiple of the diagonal entry.
// - `good_residual`: the backward error up to which a solution is not refined. A stable factorization has a few units
//   of the precision.
// - `fair_residual`: the backward error above which a solution is refused even after refinement.
// - `least_entry`: smaller entries may have lost digits or vanished. A matrix of floats is often a rounded matrix of
//   doubles, and rounding errors of subnormal numbers are not small relative to the number.
template <class FT>
struct SuperLU_tolerances;

template <>
struct SuperLU_tolerances<double>
{
  static constexpr double asymmetry = 1e-12;
  static constexpr bool pivots_show_singularity = true;
  static constexpr double suspicious_pivot = 1e-8;
  static constexpr double good_residual = 1e-10;
  static constexpr double fair_residual = 1e-6;
  static constexpr double least_entry = 0;
};

template <>
struct SuperLU_tolerances<float>
{
  static constexpr float asymmetry = 2e-6f;
  static constexpr bool pivots_show_singularity = false;
  static constexpr float good_residual = 1e-5f;
  static constexpr float fair_residual = 1e-4f;
  static constexpr float least_entry = (std::numeric_limits<float>::min)();
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_TOLERANCES_H
