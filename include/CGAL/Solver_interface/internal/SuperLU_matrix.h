// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Matrices of Eigen's and CGAL's, the thresholds for their rounding errors, and checks of them before they are given to
// SuperLU, which trusts its input. General matrices are equilibrated by powers of two (Ruiz), so that poor scales of
// rows and columns do not spoil pivoting.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_MATRIX_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_MATRIX_H

#include <CGAL/Eigen_sparse_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace internal {

// Tolerances for rounding errors in the number type `FT`.
//
// - `asymmetry`: the difference of two entries (i, j) and (j, i), relative to the geometric mean of the diagonal
//   entries i and j. It must be below `good_residual`, because only one of the two is used.
// - `pivots_show_singularity`: whether only a matrix with a small pivot can be singular. The last pivot of a singular
//   Laplacian with 200 000 rows is 1e-12 times its diagonal in double, but 0.01 times in float, where regular matrices
//   have smaller pivots.
// - `suspicious_pivot`: if so, a pivot is small below this multiple of the diagonal entry.
// - `good_residual`: the backward error up to which a solution is not refined. A stable factorization has a few units
//   of the precision.
// - `fair_residual`: the backward error above which a solution is refused even after refinement.
// - `least_entry`: smaller entries may have lost digits or vanished. A matrix of floats is often a rounded matrix of
//   doubles, and rounding errors of subnormal numbers are not small relative to the number.
template <class FT>
struct SuperLU_tolerances
{
  static constexpr bool is_double = std::is_same<FT, double>::value;
  static constexpr FT asymmetry = static_cast<FT>(is_double ? 1e-12 : 2e-6);
  static constexpr bool pivots_show_singularity = is_double;
  static constexpr FT suspicious_pivot = static_cast<FT>(1e-8);
  static constexpr FT good_residual = static_cast<FT>(is_double ? 1e-10 : 1e-5);
  static constexpr FT fair_residual = static_cast<FT>(is_double ? 1e-6 : 1e-4);
  static constexpr FT least_entry = is_double ? FT(0) : (std::numeric_limits<FT>::min)();
};

// `Eigen_sparse_matrix` with dimensions of any integer type. Its own constructors take `int` and `std::size_t`, so that
// a matrix of `unsigned int` rows, as `Poisson_reconstruction_function` has, is ambiguous.
template <class FT>
struct SuperLU_sparse_matrix : public Eigen_sparse_matrix<FT>
{
  typedef Eigen_sparse_matrix<FT> Base;

  SuperLU_sparse_matrix() = default;
  SuperLU_sparse_matrix(const Base& matrix) : Base(matrix) {}
  SuperLU_sparse_matrix(const typename Base::EigenType& matrix) : Base(matrix) {}

  template <class Integer, class = std::enable_if_t<std::is_integral<Integer>::value>>
  SuperLU_sparse_matrix(Integer dim, bool is_symmetric = false) : Base(static_cast<int>(dim), is_symmetric)
  {}

  template <class Rows, class Columns,
            class = std::enable_if_t<std::is_integral<Rows>::value && std::is_integral<Columns>::value &&
                                     !std::is_same<Columns, bool>::value>>
  SuperLU_sparse_matrix(Rows rows, Columns columns, bool is_symmetric = false)
      : Base(static_cast<int>(rows), static_cast<int>(columns), is_symmetric)
  {}
};

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

  template <class Function>
  void for_each_entry(const Function& function) const
  {
    for(int column = 0; column < size; ++column)
      for(int k = outer[column]; k < outer[column + 1]; ++k)
        function(inner[k], column);
  }

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
  for(int j = 0; j < a.cols(); ++j)
    for(int k = a.outerIndexPtr()[j], previous = -1; k < a.outerIndexPtr()[j + 1]; ++k) {
      if(a.innerIndexPtr()[k] <= previous || !std::isfinite(a.valuePtr()[k]))
        return false;
      previous = a.innerIndexPtr()[k];
    }
  return true;
}

// Whether the square matrix stores one triangle, and stands for the whole symmetric one. `Eigen_sparse_matrix` does not
// tell whether it was constructed with `is_symmetric = true`, but it then returns entries of the other triangle too.
// Such a query may insert an entry, hence the copy.
template <class FT>
bool superlu_stores_one_triangle(const Eigen_sparse_matrix<FT>& matrix)
{
  typedef typename SuperLU_matrix<FT>::InnerIterator Iterator;
  const SuperLU_matrix<FT>& a = matrix.eigen_object();
  int i = -1, j = -1; // an entry below the diagonal
  for(int column = 0; column < a.cols(); ++column)
    for(Iterator it(a, column); it; ++it) {
      if(it.row() < column)
        return false;
      if(it.row() > column && it.value() != 0) {
        i = static_cast<int>(it.row());
        j = column;
      }
    }
  return i >= 0 && Eigen_sparse_matrix<FT>(matrix).get_coef(j, i) != 0;
}

// The absolute entry of column `j` on the diagonal; 0 if it is missing
template <class FT>
FT superlu_absolute_diagonal(const SuperLU_matrix<FT>& a, int j)
{
  const int *begin = a.innerIndexPtr() + a.outerIndexPtr()[j],
            *end = a.innerIndexPtr() + a.outerIndexPtr()[j + 1];
  const int* const diagonal = std::lower_bound(begin, end, j);
  return diagonal == end || *diagonal != j ? FT(0) : std::abs(a.valuePtr()[diagonal - a.innerIndexPtr()]);
}

// Whether the pattern of the matrix is symmetric, its values are symmetric up to rounding, and the diagonal and the
// 2x2 minors are those of a positive or negative definite matrix. `sign` is the sign of the diagonal.
//
// Columns are visited in order. The entries of row j left of the diagonal must therefore occur in the same order in
// column j, above the diagonal.
template <class FT>
bool superlu_may_be_definite(const SuperLU_matrix<FT>& a, FT& sign)
{
  const FT tolerance = SuperLU_tolerances<FT>::asymmetry;
  const int* outer = a.outerIndexPtr();
  const int* inner = a.innerIndexPtr();
  const FT* value = a.valuePtr();
  std::vector<FT> roots(a.cols());
  for(int j = 0; j < a.cols(); ++j) {
    const FT diagonal = superlu_absolute_diagonal(a, j);
    if(!(diagonal > SuperLU_tolerances<FT>::least_entry))
      return false;
    roots[j] = std::sqrt(diagonal);
  }
  std::vector<int> next(outer, outer + a.cols());
  for(int j = 0; j < a.cols(); ++j) {
    if(inner[next[j]] != j) // an entry above the diagonal without a counterpart
      return false;
    if(j == 0)
      sign = value[next[j]] > 0 ? FT(1) : FT(-1);
    if(!(sign * value[next[j]] > 0))
      return false;
    for(int k = next[j] + 1; k < outer[j + 1]; ++k) {
      const int i = inner[k], mirror = next[i]++;
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

} // namespace internal
} // namespace CGAL

namespace CGAL {
namespace internal {

// Exponents of scales of the rows and columns of a matrix. The scales are powers of two, so that scaling does not
// round.
struct SuperLU_scaling
{
  std::vector<int> row, column; // empty if nothing is scaled

  // Brings the largest entries of all rows and columns close to one. Each pass of Ruiz's algorithm treats rows and
  // columns alike and halves the range of the exponents of these entries.
  template <class FT>
  void equilibrate(SuperLU_matrix<FT>& a)
  {
    row.assign(a.rows(), 0);
    column.assign(a.cols(), 0);
    const SuperLU_pattern pattern(a);
    const int none = (std::numeric_limits<int>::min)();
    bool is_scaled = true;
    for(int pass = 0; pass < 12 && is_scaled; ++pass) {
      std::vector<int> rows(a.rows(), none), columns(a.cols(), none);
      FT* value = a.valuePtr();
      pattern.for_each_entry([&](int i, int j) {
        if(*value != 0) {
          rows[i] = (std::max)(rows[i], std::ilogb(*value));
          columns[j] = (std::max)(columns[j], std::ilogb(*value));
        }
        ++value;
      });
      is_scaled = add_scales(rows, row);
      is_scaled = add_scales(columns, column) || is_scaled;
      value = a.valuePtr();
      pattern.for_each_entry([&](int i, int j) {
        *value = std::ldexp(*value, rows[i] + columns[j]);
        ++value;
      });
    }
  }

  // Whether rounding to this number type changed the entries of the matrix before scaling only by errors that are
  // small compared with the largest entries of their rows and columns
  template <class FT>
  bool keeps_digits(const SuperLU_matrix<FT>& a) const
  {
    const FT least = SuperLU_tolerances<FT>::least_entry;
    const FT* value = a.valuePtr();
    bool result = true;
    SuperLU_pattern(a).for_each_entry([&](int i, int j) {
      const FT entry = std::abs(*value++);
      result = result && (entry >= least || std::ldexp(least, row[i] + column[j]) <= 1);
    });
    return result;
  }

  // Converts right-hand sides of the original system to those of the scaled system by the exponents of the rows, and
  // solutions of the scaled system to those of the original one by those of the columns.
  template <class Block>
  static void scale(Block& b, const std::vector<int>& exponents)
  {
    if(!exponents.empty())
      for(Eigen::Index k = 0; k < b.cols(); ++k)
        for(Eigen::Index i = 0; i < b.rows(); ++i)
          b(i, k) = std::ldexp(b(i, k), exponents[i]);
  }

private:
  // Replaces exponents by those of scales, and adds them to `sums`. Returns whether there is one that is not zero.
  static bool add_scales(std::vector<int>& exponents, std::vector<int>& sums)
  {
    bool result = false;
    for(std::size_t i = 0; i < exponents.size(); ++i) {
      exponents[i] = exponents[i] == (std::numeric_limits<int>::min)() ? 0 : -exponents[i] / 2;
      sums[i] += exponents[i];
      result = result || exponents[i] != 0;
    }
    return result;
  }
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_MATRIX_H
