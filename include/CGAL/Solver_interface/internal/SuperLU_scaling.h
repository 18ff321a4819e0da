// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Equilibration of a general matrix by powers of two (Ruiz), so that poor scales of rows and columns do not spoil
// pivoting. `SuperLU_factorization.h` scales matrices that are not definite, and their right-hand sides and solutions.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SCALING_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SCALING_H

#include <CGAL/Solver_interface/internal/SuperLU_input.h>
#include <CGAL/Solver_interface/internal/SuperLU_tolerances.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace internal {

// Scales of the rows and columns of a matrix. They are powers of two, so that scaling does not round.
class SuperLU_scaling
{
public:
  // Brings the largest entries of all rows and columns close to one. Each pass of Ruiz's algorithm
  // treats rows and columns alike and halves the range of the exponents of these entries.
  template <class FT>
  void equilibrate(SuperLU_matrix<FT>& a)
  {
    m_row.assign(a.rows(), 0);
    m_column.assign(a.cols(), 0);
    const int none = (std::numeric_limits<int>::min)();
    for(int pass = 0; pass < 12; ++pass) {
      std::vector<int> row(a.rows(), none), column(a.cols(), none);
      for_each_entry(a, [&](int i, int j, FT& value) {
        if(value != 0) {
          const int exponent = std::ilogb(value);
          row[i] = (std::max)(row[i], exponent);
          column[j] = (std::max)(column[j], exponent);
        }
      });
      const bool scales_rows = add_scales(row, none, m_row),
                 scales_columns = add_scales(column, none, m_column);
      if(!scales_rows && !scales_columns)
        return;
      for_each_entry(a, [&](int i, int j, FT& value) { value = std::ldexp(value, row[i] + column[j]); });
    }
  }

  // Whether rounding to this number type changed the entries of the matrix before scaling only by errors that are
  // small compared with the largest entries of their rows and columns
  template <class FT>
  bool keeps_digits(const SuperLU_matrix<FT>& a) const
  {
    const FT least = SuperLU_tolerances<FT>::least_entry;
    if(least == 0)
      return true;
    for(int j = 0; j < a.cols(); ++j) {
      for(typename SuperLU_matrix<FT>::InnerIterator it(a, j); it; ++it) {
        if(std::abs(it.value()) < least && std::ldexp(least, m_row[it.row()] + m_column[j]) > 1)
          return false;
      }
    }
    return true;
  }

  // Converts right-hand sides of the original system to those of the scaled system
  template <class Block>
  void scale_rows(Block& b) const
  {
    scale(b, m_row);
  }

  // Converts solutions of the scaled system to those of the original system
  template <class Block>
  void scale_columns(Block& x) const
  {
    scale(x, m_column);
  }

private:
  // Replaces exponents by those of scales, and adds them to `sums`. Returns whether there is one that is not zero.
  static bool add_scales(std::vector<int>& exponents, int none, std::vector<int>& sums)
  {
    bool result = false;
    for(std::size_t i = 0; i < exponents.size(); ++i) {
      exponents[i] = exponents[i] == none ? 0 : -exponents[i] / 2;
      sums[i] += exponents[i];
      result = result || exponents[i] != 0;
    }
    return result;
  }

  template <class FT, class Function>
  static void for_each_entry(SuperLU_matrix<FT>& a, const Function& function)
  {
    for(int j = 0; j < a.cols(); ++j) {
      for(int k = a.outerIndexPtr()[j]; k < a.outerIndexPtr()[j + 1]; ++k)
        function(a.innerIndexPtr()[k], j, a.valuePtr()[k]);
    }
  }

  template <class Block>
  static void scale(Block& b, const std::vector<int>& exponents)
  {
    if(exponents.empty()) // nothing was scaled
      return;
    for(Eigen::Index k = 0; k < b.cols(); ++k) {
      for(Eigen::Index i = 0; i < b.rows(); ++i)
        b(i, k) = std::ldexp(b(i, k), exponents[i]);
    }
  }

  std::vector<int> m_row, m_column;
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SCALING_H
