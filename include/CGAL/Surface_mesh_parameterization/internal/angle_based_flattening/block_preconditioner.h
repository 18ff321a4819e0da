// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_BLOCK_PRECONDITIONER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_BLOCK_PRECONDITIONER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/symmetric_system.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The inverse of a symmetric matrix of 2x2 blocks without what couples its even unknowns to its odd ones. Of the matrix
// of Eq. 16 these are the multipliers of planarity and those of reconstruction: two weakly coupled Laplacians. Each of
// the two has a quarter of the entries of the whole, and can be factored while the other one is.
template <typename SolverTraits>
class Block_preconditioner
{
public:
  typedef Eigen::SparseMatrix<double> Matrix;

  explicit Block_preconditioner(const SolverTraits& traits)
      : m_systems{Symmetric_system<SolverTraits>(traits), Symmetric_system<SolverTraits>(traits)}
  {}

  // Factors both diagonal blocks. Returns `false` if that fails.
  bool set_matrix(const Matrix& matrix)
  {
    std::array<bool, 2> done;
    parallel_for(2, [&](int k) { done[k] = m_systems[k].set_matrix(diagonal_block(matrix, k)); });
    return done[0] && done[1];
  }

  bool apply(const Eigen::VectorXd& residual, Eigen::VectorXd& correction)
  {
    correction.resize(residual.size());
    std::array<bool, 2> done;
    parallel_for(2, [&](int k) {
      const Eigen::VectorXd part = every_other(residual, k);
      Eigen::VectorXd solution;
      done[k] = m_systems[k].solve(part, solution);
      if(done[k])
        every_other(correction, k) = solution;
    });
    return done[0] && done[1];
  }

  // The solver of one of the blocks, whose pattern is that of the one-rings of the interior vertices
  const SolverTraits& scalar_solver() const { return m_systems[0].traits(); }

private:
  template <typename Vector>
  static auto every_other(Vector& vector, int first)
  {
    return vector(Eigen::seqN(first, vector.size() / 2, 2));
  }

  // The rows and columns 2i + k of the matrix
  static Matrix diagonal_block(const Matrix& matrix, int k)
  {
    const int n = static_cast<int>(matrix.cols()) / 2;
    Matrix block(n, n);
    block.resizeNonZeros(matrix.nonZeros() / 4);
    int *outer = block.outerIndexPtr(), *inner = block.innerIndexPtr();
    double* values = block.valuePtr();
    int entries = 0;
    for(int j = 0; j < n; ++j) {
      outer[j] = entries;
      for(Matrix::InnerIterator it(matrix, 2 * j + k); it; ++it)
        if(it.row() % 2 == k) {
          inner[entries] = static_cast<int>(it.row()) / 2;
          values[entries++] = it.value();
        }
    }
    outer[n] = entries;
    return block;
  }

  std::array<Symmetric_system<SolverTraits>, 2> m_systems;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_BLOCK_PRECONDITIONER_H
