// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Forward and backward substitution with the lower factor alone, for symmetric matrices whose pivots are on the
// diagonal. `SuperLU_factors.h` solves with it, and can then free the upper factor.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERNODAL_SOLUTION_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERNODAL_SOLUTION_H

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace internal {

// Consecutive columns of L with the same pattern: a dense trapezoid, with the entries of D on its diagonal and those
// of the unit triangle of L below it.
template <class FT>
struct Supernode
{
  int first, columns, rows;
  const int* below; // the numbers of the rows below the triangle
  const FT* values;

  const FT* column(int j) const { return values + std::ptrdiff_t(j) * rows; }
};

// Triangular solutions with a symmetric factorization L D L'. `Supernodes` has `size()`, `number_of_supernodes()`,
// and `supernode(s)`, in the order of the pivots. Most supernodes are too small for calls of the BLAS.
template <class FT, class Supernodes>
class Supernodal_solution
{
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;
  typedef Supernode<FT> Node;

public:
  explicit Supernodal_solution(const Supernodes& supernodes) : m_supernodes(supernodes) {}

  // Replaces `x` by the solution, in the order of the pivots. There must be memory for as many numbers in `rows`.
  void solve(FT* x, FT* rows) const
  {
    const int number = m_supernodes.number_of_supernodes();
    for(int s = 0; s < number; ++s)
      forward(m_supernodes.supernode(s), x, rows);
    for(int s = number - 1; s >= 0; --s)
      divide_and_go_backward(m_supernodes.supernode(s), x, rows);
  }

private:
  static void forward(const Node& node, FT* x, FT* sums)
  {
    FT* top = x + node.first;
    const bool is_zero = std::all_of(top, top + node.columns, [](FT value) { return value == 0; });
    if(is_zero) // as most are of a unit vector
      return;
    const int below = node.rows - node.columns;
    for(int i = 0; i < below; ++i)
      sums[i] = 0;
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

  static void divide_and_go_backward(const Node& node, FT* x, FT* values)
  {
    for(int j = 0; j < node.columns; ++j)
      values[j] = x[node.first + j] / node.column(j)[j];
    for(int i = node.columns; i < node.rows; ++i)
      values[i] = x[node.below[i - node.columns]];
    for(int j = node.columns - 1; j >= 0; --j) {
      typedef Eigen::Map<const Vector> Column;
      const int below = node.rows - j - 1;
      values[j] -= Column(node.column(j) + j + 1, below).dot(Column(values + j + 1, below));
    }
    for(int j = 0; j < node.columns; ++j)
      x[node.first + j] = values[j];
  }

  const Supernodes& m_supernodes;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERNODAL_SOLUTION_H
