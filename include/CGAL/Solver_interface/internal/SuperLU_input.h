// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Tests of a matrix before SuperLU gets it: form, finite entries, a matching of rows and columns, and whether it may be
// definite. `SuperLU_solver_traits.h` refuses matrices by them; `SuperLU_analysis.h` and `SuperLU_scaling.h` take their
// types from here.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_INPUT_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_INPUT_H

// Checks of a matrix before it is given to SuperLU, which trusts its input.

#include <CGAL/Eigen_sparse_matrix.h>
#include <CGAL/Solver_interface/internal/SuperLU_tolerances.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace internal {

template <class FT>
using SuperLU_matrix = Eigen::SparseMatrix<FT>;

// The pattern of a compressed square matrix. It must not outlive the matrix.
struct SuperLU_pattern
{
  template <class FT>
  SuperLU_pattern(const SuperLU_matrix<FT>& a)
      : size(static_cast<int>(a.cols())), outer(a.outerIndexPtr()), inner(a.innerIndexPtr())
  {}

  std::size_t nonzeros() const { return static_cast<std::size_t>(outer[size]); }

  int size;
  const int* outer;
  const int* inner;
};

// Whether the matrix is square and not empty, its entries are finite, and the row indices of every column increase.
template <class FT>
bool superlu_is_well_formed(const SuperLU_matrix<FT>& a)
{
  if(a.rows() != a.cols() || a.rows() == 0 || !a.isCompressed())
    return false;

  for(int j = 0; j < a.cols(); ++j) {
    int previous = -1;
    for(int k = a.outerIndexPtr()[j]; k < a.outerIndexPtr()[j + 1]; ++k) {
      if(a.innerIndexPtr()[k] <= previous || !std::isfinite(a.valuePtr()[k]))
        return false;
      previous = a.innerIndexPtr()[k];
    }
  }
  return true;
}

// Whether there are off-diagonal entries and all of them are below the diagonal. Returns one of them in `(i, j)`.
template <class FT>
bool superlu_is_lower_triangle(const SuperLU_matrix<FT>& a, int& i, int& j)
{
  bool found = false;
  for(int column = 0; column < a.cols(); ++column) {
    for(typename SuperLU_matrix<FT>::InnerIterator it(a, column); it; ++it) {
      if(it.row() < column)
        return false;
      if(it.row() > column && it.value() != 0) {
        i = static_cast<int>(it.row());
        j = column;
        found = true;
      }
    }
  }
  return found;
}

// `Eigen_sparse_matrix` does not tell whether it was constructed with `is_symmetric = true` and stores one triangle
// only. It then returns entries of the other triangle too. Such a query may insert an entry, hence the copy.
template <class FT>
bool superlu_stores_one_triangle(const Eigen_sparse_matrix<FT>& matrix)
{
  int i = 0, j = 0;
  if(!superlu_is_lower_triangle(matrix.eigen_object(), i, j))
    return false;
  Eigen_sparse_matrix<FT> copy(matrix);
  return copy.get_coef(j, i) != 0;
}

// The square roots of the absolute diagonal entries; empty if a diagonal entry is missing, zero or out of range, or
// if their signs differ. `sign` is their common sign.
template <class FT>
std::vector<FT> superlu_diagonal_roots(const SuperLU_matrix<FT>& a, FT& sign)
{
  std::vector<FT> roots(a.cols(), FT(0));
  for(int j = 0; j < a.cols(); ++j) {
    const int* begin = a.innerIndexPtr() + a.outerIndexPtr()[j];
    const int* end = a.innerIndexPtr() + a.outerIndexPtr()[j + 1];
    const int* diagonal = std::lower_bound(begin, end, j);
    if(diagonal == end || *diagonal != j)
      return {};
    const FT value = a.valuePtr()[diagonal - a.innerIndexPtr()];
    if(j == 0)
      sign = value > 0 ? FT(1) : FT(-1);
    if(!(sign * value > SuperLU_tolerances<FT>::least_entry))
      return {};
    roots[j] = std::sqrt(sign * value);
  }
  return roots;
}

// Whether the pattern of the matrix is symmetric, its values are symmetric up to rounding, and the diagonal and the
// 2x2 minors are those of a positive or negative definite matrix.
//
// Columns are visited in order. The entries of row j left of the diagonal must therefore occur in the same order in
// column j, above the diagonal.
template <class FT>
bool superlu_may_be_definite(const SuperLU_matrix<FT>& a, FT& sign)
{
  const FT tolerance = SuperLU_tolerances<FT>::asymmetry;
  const std::vector<FT> roots = superlu_diagonal_roots(a, sign);
  if(roots.empty())
    return false;

  const int* outer = a.outerIndexPtr();
  const int* inner = a.innerIndexPtr();
  const FT* value = a.valuePtr();
  std::vector<int> next(outer, outer + a.cols());
  for(int j = 0; j < a.cols(); ++j) {
    if(inner[next[j]] != j) // an entry above the diagonal without a counterpart
      return false;
    for(int k = next[j] + 1; k < outer[j + 1]; ++k) {
      const int i = inner[k];
      const int mirror = next[i]++;
      if(mirror >= outer[i + 1] || inner[mirror] != j)
        return false;
      const FT scale = roots[i] * roots[j];
      if(std::abs(value[k] - value[mirror]) > tolerance * scale ||
         std::abs(value[k]) > (1 + tolerance) * scale)
        return false;
    }
  }
  return true;
}

// Whether the rows and columns can be matched along stored entries. Otherwise SuperLU writes outside of its arrays.
// Augmenting paths are searched depth-first.
class SuperLU_matching
{
public:
  explicit SuperLU_matching(const SuperLU_pattern& a)
      : m_outer(a.outer), m_inner(a.inner), m_n(a.size), m_column_of_row(m_n, -1),
        m_cheap(m_outer, m_outer + m_n), m_next(m_n), m_root(m_n, -1)
  {}

  bool is_perfect()
  {
    for(int column = 0; column < m_n; ++column) {
      if(!augment(column))
        return false;
    }
    return true;
  }

private:
  // An unmatched row of the column, or -1. Matched rows remain matched, so each entry is examined once.
  int free_row(int column)
  {
    while(m_cheap[column] < m_outer[column + 1]) {
      const int row = m_inner[m_cheap[column]++];
      if(m_column_of_row[row] < 0)
        return row;
    }
    return -1;
  }

  // A column that is matched to a row of `column` and not yet visited from `root`, or -1
  int next_column(int column, int root)
  {
    while(m_next[column] < m_outer[column + 1]) {
      const int other = m_column_of_row[m_inner[m_next[column]++]];
      if(m_root[other] != root)
        return other;
    }
    return -1;
  }

  void visit(int column, int root)
  {
    m_root[column] = root;
    m_next[column] = m_outer[column];
    m_path.push_back(column);
  }

  bool augment(int root)
  {
    m_path.clear();
    visit(root, root);
    while(!m_path.empty()) {
      const int column = m_path.back();
      const int row = free_row(column);
      if(row >= 0) {
        match_path(row);
        return true;
      }
      const int other = next_column(column, root);
      if(other >= 0)
        visit(other, root);
      else
        m_path.pop_back();
    }
    return false;
  }

  // Every column of the path gets the row through which the path leaves it.
  void match_path(int row)
  {
    while(true) {
      m_column_of_row[row] = m_path.back();
      m_path.pop_back();
      if(m_path.empty())
        return;
      row = m_inner[m_next[m_path.back()] - 1];
    }
  }

  const int* m_outer;
  const int* m_inner;
  int m_n;
  std::vector<int> m_column_of_row, m_cheap, m_next, m_root, m_path;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_INPUT_H
