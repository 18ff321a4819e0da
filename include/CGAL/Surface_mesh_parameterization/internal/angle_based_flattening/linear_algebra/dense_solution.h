// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_DENSE_SOLUTION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_DENSE_SOLUTION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Sparse solvers take a hundred times as long to begin with a system of this size as it takes to solve it.
inline constexpr int largest_dense_system = 48;

// Cholesky's factors of a small matrix, on the stack
class Dense_factors
{
public:
  // Whether solvers that leave the precision to us also leave small systems to us
  template <int BlockSize>
  static bool are_wanted(const Linear_solvers& solvers, const Block_matrix<BlockSize>& matrix)
  {
    return solvers->has_low_precision && matrix.size() <= largest_dense_system;
  }

  // Returns `false` if the matrix is not definite, but for rounding: then sparse solvers say what to do.
  template <int BlockSize>
  bool set_matrix(const Block_matrix<BlockSize>& blocks)
  {
    Matrix matrix = Matrix::Zero(blocks.size(), blocks.size());
    for(int j = 0; j < blocks.columns_of_blocks(); ++j)
      for(int e = blocks.begin[j]; e < blocks.begin[j + 1]; ++e)
        matrix.template block<BlockSize, BlockSize>(BlockSize * blocks.row[e], BlockSize * j) =
            blocks.block[e];
    m_factors.compute(matrix);
    if(m_factors.info() != Eigen::Success)
      return false;
    const auto pivots = m_factors.matrixLLT().diagonal().array().square();
    return (pivots > least_pivot * matrix.diagonal().array()).all();
  }

  // Returns `false` if the solution is not finite.
  bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution) const
  {
    solution = m_factors.solve(right_hand_side);
    return solution.allFinite();
  }

private:
  typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, largest_dense_system,
                        largest_dense_system>
      Matrix;

  static constexpr double least_pivot = 1e-12; // of an entry on the diagonal

  Eigen::LLT<Matrix> m_factors;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_DENSE_SOLUTION_H
