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

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The inverse of a symmetric matrix of 2x2 blocks without what couples its even unknowns to its odd ones. Of the matrix
// of Eq. 16 these are the multipliers of planarity and those of reconstruction: two weakly coupled Laplacians. Each of
// the two has a quarter of the entries of the whole, and can be factored while the other one is, if there can be two
// solvers; else one solver gets both as one matrix.
template <typename System>
class Block_preconditioner
{
  static constexpr int number_of_systems = Owns_factorization<typename System::Traits>::value ? 2 : 1;

public:
  typedef Eigen::SparseMatrix<double> Matrix;

  explicit Block_preconditioner(const typename System::Traits& traits)
  {
    for(int k = 0; k < number_of_systems; ++k)
      m_systems.emplace_back(traits);
  }

  // Factors both diagonal blocks. Returns `false` if that fails.
  bool set_matrix(const Matrix& matrix)
  {
    if(number_of_systems == 1)
      return m_systems.front().set_matrix(side_by_side(diagonal_block(matrix, 0), diagonal_block(matrix, 1)));
    std::array<bool, 2> done;
    parallel_for(2, [&](int k) { done[k] = m_systems[k].set_matrix(diagonal_block(matrix, k)); });
    return done[0] && done[1];
  }

  bool solve(const Eigen::VectorXd& residual, Eigen::VectorXd& correction)
  {
    const Eigen::Index n = residual.size() / number_of_systems;
    Eigen::VectorXd sorted(residual.size());
    sorted << every_other(residual, 0), every_other(residual, 1);
    std::array<bool, number_of_systems> done;
    parallel_for(number_of_systems, [&](int k) {
      Eigen::VectorXd solution;
      done[k] = m_systems[k].solve(sorted.segment(k * n, n), solution);
      if(done[k])
        sorted.segment(k * n, n) = solution;
    });
    correction.resize(residual.size());
    every_other(correction, 0) = sorted.head(residual.size() / 2);
    every_other(correction, 1) = sorted.tail(residual.size() / 2);
    return done.front() && done.back();
  }

  // The solver of one of the blocks, whose pattern is that of the one-rings of the interior vertices
  const typename System::Traits& scalar_solver() const { return m_systems.front().traits(); }

private:
  template <typename Vector>
  static auto every_other(Vector& vector, int first)
  {
    return vector(Eigen::seqN(first, vector.size() / 2, 2));
  }

  static Matrix side_by_side(const Matrix& a, const Matrix& b)
  {
    const int n = static_cast<int>(a.cols()), entries = static_cast<int>(a.nonZeros());
    Matrix both(2 * n, 2 * n);
    both.resizeNonZeros(2 * entries);
    for(int j = 0; j <= n; ++j) {
      both.outerIndexPtr()[j] = a.outerIndexPtr()[j];
      both.outerIndexPtr()[n + j] = entries + b.outerIndexPtr()[j];
    }
    std::copy_n(a.innerIndexPtr(), entries, both.innerIndexPtr());
    std::transform(b.innerIndexPtr(), b.innerIndexPtr() + entries, both.innerIndexPtr() + entries,
                   [n](int row) { return n + row; });
    std::copy_n(a.valuePtr(), entries, both.valuePtr());
    std::copy_n(b.valuePtr(), entries, both.valuePtr() + entries);
    return both;
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

  std::vector<System> m_systems;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_BLOCK_PRECONDITIONER_H
