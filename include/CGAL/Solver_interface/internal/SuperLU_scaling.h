// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Equilibration of a general matrix by powers of two (Ruiz), so that poor scales of rows and columns do not spoil
// pivoting. `SuperLU_factorization.h` scales matrices that are not definite, and their right-hand sides and solutions.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SCALING_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SCALING_H

#include <CGAL/Solver_interface/internal/SuperLU_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

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

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SCALING_H
