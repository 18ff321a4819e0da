// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The supernodes of SuperLU's lower factor, and substitution with it alone, for symmetric matrices whose pivots are on
// the diagonal. `SuperLU_factors.h` solves with it, and can then free the upper factor.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_LOWER_FACTOR_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_LOWER_FACTOR_H

#include <CGAL/Solver_interface/internal/SuperLU_headers.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace internal {
inline namespace CGAL_SUPERLU_TYPES {

// Consecutive columns of L with the same pattern: a dense trapezoid, with the entries of U on its diagonal, and those
// of the unit triangle of L below it.
template <class FT>
struct Supernode
{
  int first, columns, rows;
  const int* below; // the numbers of the rows below the triangle
  const FT* values;

  const FT* column(int j) const { return values + std::ptrdiff_t(j) * rows; }
};

// A view of the lower factor. With the pivots as D, a symmetric matrix is L D L'.
template <class FT>
class SuperLU_lower_factor
{
public:
  explicit SuperLU_lower_factor(const superlu::SuperMatrix& matrix)
      : m_store(*static_cast<const superlu::SCformat*>(matrix.Store))
  {}

  int number_of_supernodes() const { return m_store.nsuper + 1; }

  Supernode<FT> supernode(int s) const
  {
    const int first = m_store.sup_to_col[s], columns = m_store.sup_to_col[s + 1] - first;
    const auto begin = m_store.rowind_colptr[first];
    return {first, columns, static_cast<int>(m_store.rowind_colptr[first + 1] - begin),
            m_store.rowind + begin + columns, values() + m_store.nzval_colptr[first]};
  }

  // The entry of U on the diagonal of a column
  FT pivot(int column) const
  {
    const int first = m_store.sup_to_col[m_store.col_to_sup[column]];
    return values()[m_store.nzval_colptr[column] + (column - first)];
  }

  // Replaces `x` by the solution with L D L', in the order of the pivots. There must be memory for as many numbers in
  // `rows`. Most supernodes are too small for calls of the BLAS.
  void solve(FT* x, FT* rows) const
  {
    for(int s = 0; s < number_of_supernodes(); ++s)
      forward(supernode(s), x, rows);
    for(int s = number_of_supernodes() - 1; s >= 0; --s)
      divide_and_go_backward(supernode(s), x, rows);
  }

private:
  const FT* values() const { return static_cast<const FT*>(m_store.nzval); }

  static void forward(const Supernode<FT>& node, FT* x, FT* sums)
  {
    FT* top = x + node.first;
    if(std::all_of(top, top + node.columns,
                   [](FT value) { return value == 0; })) // as most are of a unit vector
      return;
    const int below = node.rows - node.columns;
    std::fill(sums, sums + below, FT(0));
    for(int j = 0; j < node.columns; ++j) {
      const FT* column = node.column(j);
      const FT value = top[j];
      for(int i = j + 1; i < node.columns; ++i)
        top[i] -= column[i] * value;
      for(int i = 0; i < below; ++i)
        sums[i] += column[node.columns + i] * value;
    }
    for(int i = 0; i < below; ++i)
      x[node.below[i]] -= sums[i];
  }

  static void divide_and_go_backward(const Supernode<FT>& node, FT* x, FT* values)
  {
    for(int j = 0; j < node.columns; ++j)
      values[j] = x[node.first + j] / node.column(j)[j];
    for(int i = node.columns; i < node.rows; ++i)
      values[i] = x[node.below[i - node.columns]];
    for(int j = node.columns - 1; j >= 0; --j) {
      typedef Eigen::Map<const Eigen::Matrix<FT, Eigen::Dynamic, 1>> Column;
      const int below = node.rows - j - 1;
      values[j] -= Column(node.column(j) + j + 1, below).dot(Column(values + j + 1, below));
    }
    std::copy(values, values + node.columns, x + node.first);
  }

  const superlu::SCformat& m_store;
};

} // namespace CGAL_SUPERLU_TYPES
} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_LOWER_FACTOR_H
