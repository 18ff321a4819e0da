// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SPARSE_MATRIX_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SPARSE_MATRIX_H

#include <CGAL/Eigen_sparse_matrix.h>

#include <type_traits>

namespace CGAL {
namespace internal {

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

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_SPARSE_MATRIX_H
