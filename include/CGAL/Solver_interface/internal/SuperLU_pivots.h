// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// What the pivots of a factorization by SuperLU tell about its matrix: whether it is definite, and whether it may be
// singular. `SuperLU_factorization.h` and `SuperLU_preconditioner.h` refuse matrices by them.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_PIVOTS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_PIVOTS_H

#include <CGAL/Solver_interface/internal/SuperLU_factors.h>
#include <CGAL/Solver_interface/internal/SuperLU_input.h>
#include <CGAL/SuperLU_options.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace internal {
inline namespace CGAL_SUPERLU_TYPES {

// The elimination tree of A + A' and diagonal pivots are correct only if all pivots are on the diagonal and have the
// same sign. Elimination is then stable.
template <class FT>
bool superlu_pivots_have_sign(const SuperLU_factors<FT>& factors, FT sign)
{
  for(int i = 0; i < factors.size(); ++i)
    if(!factors.is_pivot_diagonal(i) || !(sign * factors.pivot(i) > 0))
      return false;
  return true;
}

// The least ratio of a pivot to the `scale` of its column in the matrix, or 0 if a ratio is NaN
template <class FT, class Scale>
FT superlu_least_relative_pivot(const SuperLU_factors<FT>& factors, const Scale& scale)
{
  FT least = (std::numeric_limits<FT>::max)();
  for(int i = 0; i < factors.size(); ++i) {
    const FT ratio = std::abs(factors.pivot(i)) / scale(i);
    if(!std::isfinite(ratio))
      return 0;
    least = (std::min)(least, ratio);
  }
  return least;
}

template <class FT>
FT superlu_absolute_diagonal(const SuperLU_matrix<FT>& a, int j)
{
  for(int k = a.outerIndexPtr()[j]; k < a.outerIndexPtr()[j + 1]; ++k)
    if(a.innerIndexPtr()[k] == j)
      return std::abs(a.valuePtr()[k]);
  return 0;
}

template <class FT>
FT superlu_least_relative_pivot(const SuperLU_factors<FT>& factors, const SuperLU_matrix<FT>& a)
{
  return superlu_least_relative_pivot(factors, [&](int i) { return superlu_absolute_diagonal(a, i); });
}

// Factors a matrix in symmetric mode, if that finds it definite, and keeps its lower factor only.
template <class FT>
bool superlu_factor_by_pivots(SuperLU_factors<FT>& factors, const SuperLU_matrix<FT>& a,
                              const SuperLU_options& options, FT sign)
{
  // smaller pivots may be rounding errors, so their sign means nothing
  const FT significant = 16 * std::numeric_limits<FT>::epsilon();
  if(!factors.factor(a, options) || !superlu_pivots_have_sign(factors, sign) ||
     !(superlu_least_relative_pivot(factors, a) > significant))
    return false;
  factors.keep_lower_factor_only();
  return true;
}

// The largest absolute number; infinity if one is not finite
template <class FT>
double superlu_largest(const FT* x, std::ptrdiff_t size)
{
  double result = 0;
  for(std::ptrdiff_t i = 0; i < size; ++i) {
    if(!std::isfinite(x[i]))
      return std::numeric_limits<double>::infinity();
    result = (std::max)(result, static_cast<double>(std::abs(x[i])));
  }
  return result;
}

} // namespace CGAL_SUPERLU_TYPES
} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_PIVOTS_H
