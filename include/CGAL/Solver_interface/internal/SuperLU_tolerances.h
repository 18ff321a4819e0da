// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_TOLERANCES_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_TOLERANCES_H

#include <limits>

namespace CGAL {
namespace internal {

// What is put down to rounding, in the number type `FT`.
//
// - `asymmetry`: the difference of two entries that mirror one another, in units of the geometric mean of their entries of
//   the diagonal. It must be below `good_residual`, as only one of them is used.
// - `pivots_show_singularity`: whether a singular matrix is known by a pivot that is small. The last pivot of a singular
//   Laplacian with 200 000 rows is a millionth of a millionth of its diagonal in double, but a hundredth in float, where
//   pivots of regular matrices are smaller.
// - `suspicious_pivot`: if so, the ratio to the entry of the diagonal below which a pivot is suspected.
// - `good_residual`: the backward error up to which a solution is not refined. That of a stable factorization is a few
//   units of the precision.
// - `fair_residual`: the backward error above which a solution is refused in spite of refinement.
// - `least_entry`: what is smaller may have lost its digits, or vanished. A matrix of floats is often one of doubles that
//   was rounded, and below the normal numbers the error of that is not a relative one.
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
