// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Preconditions Eq. 16 by its two scalar matrices, one of planarity and one of reconstruction, either much cheaper than
// the whole, and by the whole matrix near slivers, steep cones and holes (multiplicative Schwarz). These few vertices
// would cost most of the steps otherwise. `newton_equation.h` applies it in conjugate gradients.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEWTON_PRECONDITIONER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEWTON_PRECONDITIONER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/part_of_blocks.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The inverse of a symmetric matrix of 2x2 blocks without what couples its even unknowns to its odd ones, completed
// near some blocks. Of the matrix of Eq. 16, the unknowns are the multipliers of planarity and those of
// reconstruction: two weakly coupled Laplacians. Each of the two has a quarter of the entries of the whole, and they
// are factored at once.
//
// They precondition badly near vertices where both multipliers are strongly coupled, at slivers and steep cones, and
// near the blocks of holes in the matrix Z' S Z of `Bound_matrix`: the scalar matrices have each hole as one node, and
// know nothing of the translations. So the whole matrix is solved near these blocks as well.
class Newton_preconditioner
{
  // From this size on, one matrix is factored after the other: memory matters more than time then.
  static constexpr int many_blocks = 250000;

  // One takes up to twice as many steps, three or four take longer to factor.
  static constexpr int rings_of_holes = 2;

public:
  // The pattern has two blocks for each of the `holes` at its end. Both scalar matrices have one pattern, which is
  // analyzed here.
  Newton_preconditioner(const Linear_solvers& solvers, int holes, const Block_matrix<2>& pattern)
      : m_near_solver(solvers->low_precision()), m_has_holes(holes > 0)
  {
    m_scalar_solver[0] = solvers->low_precision();
    if(m_has_holes) {
      std::vector<char> is_global(pattern.columns_of_blocks(), true);
      std::fill(is_global.end() - holes, is_global.end(), false);
      m_global_part.set(is_global);
      m_is_near_holes.assign(is_global.size(), false);
      std::fill(m_is_near_holes.end() - 2 * holes, m_is_near_holes.end(), true);
      add_rings(pattern, rings_of_holes, m_is_near_holes);
      Block_matrix<2> part;
      m_global_part.take_pattern(pattern, part);
      m_scalar_solver[0]->analyze_pattern(part);
    } else {
      m_scalar_solver[0]->analyze_pattern(pattern);
    }
    m_scalar_solver[1] = m_scalar_solver[0]->copy();
  }

  // Factors the two scalar matrices, without translations of holes. Returns `false` if that fails.
  bool set_global_matrix(const Block_matrix<2>& matrix)
  {
    Block_matrix<2> part;
    if(m_has_holes)
      m_global_part.take(matrix, part);
    const Block_matrix<2>& global = m_has_holes ? part : matrix;
    take_diagonal(global, m_factored_diagonal);
    m_scale = Eigen::VectorXd::Ones(global.size());
    std::array<bool, 2> done;
    const auto factor = [&](int k) { done[k] = m_scalar_solver[k]->set_matrix(Diagonal_part<2>{global, k}); };
    if(global.columns_of_blocks() < many_blocks) {
      parallel_for(2, factor, global.columns_of_blocks());
    } else {
      factor(0);
      factor(1);
    }
    return done[0] && done[1];
  }

  // Chooses the blocks near which the whole matrix is to be solved, and factors it there. The matrix is referred to by
  // `start()` and `solve()`. The scalar matrices may be those of an earlier one.
  bool set_near_matrix(const Block_matrix<2>& matrix)
  {
    rescale(matrix);
    m_matrix = &matrix;
    find_strongly_coupled_blocks(matrix, m_coupling, m_is_near);
    if(m_has_holes)
      std::transform(m_is_near.begin(), m_is_near.end(), m_is_near_holes.begin(), m_is_near.begin(),
                     [](char a, char b) { return a || b; });
    m_near_part.set(m_is_near);
    if(!has_near_part())
      return true;
    m_near_part.take(matrix, m_near_matrix);
    return m_near_solver->set_matrix(m_near_matrix);
  }

  // Whether there is something to solve near any blocks
  bool has_near_part() const { return m_near_part.size() > 0; }

  // Solves near the blocks: there `residual` vanishes then.
  bool start(Eigen::VectorXd& residual, Eigen::VectorXd& x)
  {
    x = Eigen::VectorXd::Zero(residual.size());
    if(!has_near_part())
      return true;
    m_near_part.take(residual, m_near_residual);
    if(!m_near_solver->solve(m_near_residual, m_near))
      return false;
    m_near_part.add(m_near, x);
    m_near_part.subtract_columns(*m_matrix, m_near, residual);
    return true;
  }

  // After `start()`, conjugate gradients keep residuals at zero near the blocks but for rounding, if each correction
  // leaves them so. Then this is symmetric, without solving near the blocks beforehand, too.
  bool solve(const Eigen::VectorXd& residual, Eigen::VectorXd& correction)
  {
    if(!solve_globally(residual, correction))
      return false;
    if(!has_near_part())
      return true;
    m_near_part.take(residual, m_near_residual);
    m_near_part.subtract_rows(*m_matrix, correction, m_near_residual);
    if(!m_near_solver->solve(m_near_residual, m_near))
      return false;
    m_near_part.add(m_near, correction);
    return true;
  }

  // Factorizations of the last matrices that low precision was not enough for
  int repeated_global_factorizations() const
  {
    return m_scalar_solver[0]->is_repeated() + m_scalar_solver[1]->is_repeated();
  }
  bool is_near_repeated() const { return has_near_part() && m_near_solver->is_repeated(); }

  // A solver that may know the pattern of the scalar matrices, that of the one-rings of the interior vertices
  std::unique_ptr<Linear_solver> scalar_solver() const { return m_scalar_solver[0]->copy(); }

private:
  // Uses the factors for a later matrix with another diagonal. The equations of reconstruction change, by more than
  // those of planarity, and scaling makes up for a part of that: with all of it, slivers take more steps.
  void rescale(const Block_matrix<2>& matrix)
  {
    take_diagonal(matrix, m_diagonal);
    if(m_has_holes)
      m_global_part.take(m_diagonal, m_global_diagonal);
    const Eigen::VectorXd& diagonal = m_has_holes ? m_global_diagonal : m_diagonal;
    for(Eigen::Index i = 1; i < diagonal.size(); i += 2)
      m_scale[i] = std::sqrt(std::sqrt(m_factored_diagonal[i] / diagonal[i]));
  }

  bool solve_globally(const Eigen::VectorXd& residual, Eigen::VectorXd& correction)
  {
    if(!m_has_holes)
      return solve_scalar_systems(residual, correction);
    m_global_part.take(residual, m_global_residual);
    if(!solve_scalar_systems(m_global_residual, m_global_correction))
      return false;
    correction = Eigen::VectorXd::Zero(residual.size());
    m_global_part.add(m_global_correction, correction);
    return true;
  }

  bool solve_scalar_systems(const Eigen::VectorXd& residual, Eigen::VectorXd& correction)
  {
    const Eigen::Index n = residual.size() / 2;
    std::array<bool, 2> done;
    const auto solve = [&](int k) {
      m_sorted[k].resize(n);
      for(Eigen::Index i = 0; i < n; ++i)
        m_sorted[k][i] = m_scale[2 * i + k] * residual[2 * i + k];
      done[k] = m_scalar_solver[k]->solve(m_sorted[k], m_solution[k]);
    };
    parallel_for(2, solve, static_cast<int>(n));
    if(!done[0] || !done[1])
      return false;
    correction.resize(residual.size());
    for(Eigen::Index i = 0; i < residual.size(); ++i)
      correction[i] = m_scale[i] * m_solution[i % 2][i / 2];
    return true;
  }

  std::array<std::unique_ptr<Linear_solver>, 2> m_scalar_solver;
  std::unique_ptr<Linear_solver> m_near_solver;
  bool m_has_holes;
  std::vector<char> m_is_near_holes; // these two only with holes
  Part_of_blocks m_global_part;
  Part_of_blocks m_near_part;
  const Block_matrix<2>* m_matrix = nullptr;
  Eigen::VectorXd m_factored_diagonal; // of the scalar matrices
  Eigen::VectorXd m_scale;             // of residuals and corrections
  std::vector<double> m_coupling;      // from here on what is used again for its memory only
  std::vector<char> m_is_near;
  Block_matrix<2> m_near_matrix;
  std::array<Eigen::VectorXd, 2> m_sorted, m_solution;
  Eigen::VectorXd m_near_residual, m_near, m_global_residual, m_global_correction, m_diagonal,
      m_global_diagonal;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEWTON_PRECONDITIONER_H
