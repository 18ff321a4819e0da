// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Preconditions Eq. 16 by its two scalar matrices, one of planarity and one of reconstruction. Either is much cheaper
// than the whole. `newton_equation.h` applies it in conjugate gradients, through `near_preconditioner.h`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_BLOCK_PRECONDITIONER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_BLOCK_PRECONDITIONER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/mixed_precision.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/symmetric_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The inverse of a symmetric matrix of 2x2 blocks without what couples its even unknowns to its odd ones. Of the matrix
// of Eq. 16 these are the multipliers of planarity and those of reconstruction: two weakly coupled Laplacians. Each of
// the two has a quarter of the entries of the whole, and can be factored while the other one is, if there can be two
// solvers; else one solver gets both as one matrix. All matrices have one pattern, which is analyzed once.
class Block_preconditioner
{
  typedef Preconditioning_system System;

  // From this size on, one matrix is factored after the other: memory matters more than time then.
  static constexpr int many_blocks = 250000;

public:
  explicit Block_preconditioner(const Linear_solvers& solvers)
      : m_solvers(solvers), m_first(solvers, solvers->low_precision())
  {}

  // Analyzes the pattern of both diagonal blocks, which need no values yet.
  void analyze_pattern(const Block_matrix<2>& matrix)
  {
    if(m_solvers->is_independent) {
      m_first.analyze_pattern(matrix);
      m_second.emplace(m_solvers, m_first.low_precision_solver());
    }
  }

  // Factors both diagonal blocks, whose pattern was analyzed. Returns `false` if that fails.
  bool set_matrix(const Block_matrix<2>& matrix)
  {
    take_diagonal(matrix, m_diagonal);
    m_scale = Eigen::VectorXd::Ones(matrix.size());
    if(!m_second)
      return m_first.set_matrix(Diagonal_parts<2>{matrix});
    std::array<bool, 2> done;
    const auto set = [&](int k) { done[k] = system(k).set_matrix(Diagonal_parts<2>{matrix, k, k + 1}); };
    if(matrix.columns_of_blocks() < many_blocks) {
      parallel_for(2, set, matrix.columns_of_blocks());
    } else {
      set(0);
      set(1);
    }
    return done[0] && done[1];
  }

  // Uses the factors for a later matrix with another diagonal. The equations of reconstruction change, by more than
  // those of planarity, and scaling makes up for a part of that: with all of it, slivers take more steps.
  void rescale(const Eigen::VectorXd& diagonal)
  {
    for(Eigen::Index i = 1; i < diagonal.size(); i += 2)
      m_scale[i] = std::sqrt(std::sqrt(m_diagonal[i] / diagonal[i]));
  }

  bool solve(const Eigen::VectorXd& residual, Eigen::VectorXd& correction)
  {
    const int systems = m_second ? 2 : 1;
    const Eigen::Index half = residual.size() / 2, n = residual.size() / systems;
    std::array<bool, 2> done = {true, true};
    const auto solve = [&](int k) {
      m_sorted[k].resize(n);
      for(Eigen::Index i = 0; i < n; ++i) {
        // One system gets the first unknowns of all blocks before the second ones.
        const Eigen::Index j = 2 * (i % half) + (i < half ? k : 1);
        m_sorted[k][i] = m_scale[j] * residual[j];
      }
      done[k] = system(k).solve(m_sorted[k], m_solution[k]);
    };
    parallel_for(systems, solve, static_cast<int>(n));
    if(!done[0] || !done[1])
      return false;
    correction.resize(residual.size());
    for(Eigen::Index i = 0; i < residual.size(); ++i) {
      const Eigen::Index k = i % 2;
      correction[i] = m_scale[i] * (systems == 2 ? m_solution[k][i / 2] : m_solution[0][k * half + i / 2]);
    }
    return true;
  }

  // Factorizations of the last matrix that low precision was not enough for
  int repeated_factorizations() const
  {
    return m_first.is_repeated() + (m_second && m_second->is_repeated());
  }

  // A solver that may know the pattern of one of the blocks, that of the one-rings of the interior vertices
  std::unique_ptr<Linear_solver> low_precision_solver() const { return m_first.low_precision_solver(); }

private:
  System& system(int k) { return k == 0 ? m_first : *m_second; }

  Linear_solvers m_solvers;
  System m_first;
  std::optional<System> m_second;
  Eigen::VectorXd m_diagonal, m_scale; // of the matrix that was factored, and of residuals and corrections
  std::array<Eigen::VectorXd, 2> m_sorted, m_solution;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_BLOCK_PRECONDITIONER_H
