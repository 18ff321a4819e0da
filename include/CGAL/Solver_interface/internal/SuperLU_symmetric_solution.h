// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SYMMETRIC_SOLUTION_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SYMMETRIC_SOLUTION_H

#include <CGAL/Solver_interface/internal/SuperLU_headers.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

// Triangular solutions with the factor L of a symmetric matrix alone. With all pivots on the diagonal U is D L', and D
// is kept with the supernodes of L. SuperLU's own solution reads both factors, and calls the BLAS for every one of the
// supernodes, most of which are too small for that.
template <class FT>
class SuperLU_symmetric_solution
{
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;

public:
  explicit SuperLU_symmetric_solution(const superlu::SuperMatrix& lower)
      : m_lower(*static_cast<const superlu::SCformat*>(lower.Store)), m_size(lower.ncol)
  {}

  // Replaces `x` by the solution, in the order of the pivots.
  void solve(Vector& x) const
  {
    std::vector<FT> rows(m_size);
    for(int s = 0; s <= m_lower.nsuper; ++s)
      forward(supernode(s), x.data(), rows.data());
    for(int s = 0; s <= m_lower.nsuper; ++s)
      divide(supernode(s), x.data());
    for(int s = m_lower.nsuper; s >= 0; --s)
      backward(supernode(s), x.data(), rows.data());
  }

private:
  // Consecutive columns with the same pattern: a dense trapezoid, of which the unit lower part is that of L.
  struct Supernode
  {
    int first, columns, rows;
    const int* row;
    const FT* values;

    const FT* column(int j) const { return values + std::ptrdiff_t(j) * rows; }
  };

  Supernode supernode(int s) const
  {
    const int first = m_lower.sup_to_col[s];
    const auto row_begin = m_lower.rowind_colptr[first];
    return {first, m_lower.sup_to_col[s + 1] - first,
            static_cast<int>(m_lower.rowind_colptr[first + 1] - row_begin), m_lower.rowind + row_begin,
            static_cast<const FT*>(m_lower.nzval) + m_lower.nzval_colptr[first]};
  }

  static void forward(const Supernode& node, FT* x, FT* sums)
  {
    FT* top = x + node.first;
    for(int i = node.columns; i < node.rows; ++i)
      sums[i] = 0;
    for(int j = 0; j < node.columns; ++j) {
      const FT* column = node.column(j);
      const FT value = top[j];
      for(int i = j + 1; i < node.columns; ++i)
        top[i] -= column[i] * value;
      for(int i = node.columns; i < node.rows; ++i)
        sums[i] += column[i] * value;
    }
    for(int i = node.columns; i < node.rows; ++i)
      x[node.row[i]] -= sums[i];
  }

  static void divide(const Supernode& node, FT* x)
  {
    for(int j = 0; j < node.columns; ++j)
      x[node.first + j] /= node.column(j)[j];
  }

  static void backward(const Supernode& node, FT* x, FT* values)
  {
    for(int i = 0; i < node.columns; ++i)
      values[i] = x[node.first + i];
    for(int i = node.columns; i < node.rows; ++i)
      values[i] = x[node.row[i]];
    for(int j = node.columns - 1; j >= 0; --j) {
      typedef Eigen::Map<const Vector> Column;
      const int below = node.rows - j - 1;
      values[j] -= Column(node.column(j) + j + 1, below).dot(Column(values + j + 1, below));
    }
    for(int j = 0; j < node.columns; ++j)
      x[node.first + j] = values[j];
  }

  const superlu::SCformat& m_lower;
  int m_size;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SYMMETRIC_SOLUTION_H
