// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Completes `block_preconditioner.h` near slivers, steep cones and holes by solving the whole matrix there
// (multiplicative Schwarz). `newton_equation.h` applies it to Eq. 16. Without it, these few vertices would cost most of
// the steps.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEAR_PRECONDITIONER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEAR_PRECONDITIONER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_preconditioner.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/coupled_blocks.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/mixed_precision.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/part_of_blocks.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Preconditions a matrix whose two scalar matrices are good far from some blocks, and bad near them: those of vertices
// where both multipliers are strongly coupled, at slivers and steep cones; and those of holes in the matrix Z' S Z of
// `Bound_matrix`, for the scalar matrices have each hole as one node, and know nothing of the translations. So the
// whole matrix is solved near these blocks as well (multiplicative Schwarz).
class Near_preconditioner
{
  // One takes up to twice as many steps, three or four take longer to factor.
  static constexpr int rings_of_holes = 2;

public:
  // The pattern has two blocks for each of the `holes` at its end. `global` preconditions the part without
  // translations.
  Near_preconditioner(const Linear_solvers& solvers, Block_preconditioner& global, int holes,
                      const Block_matrix<2>& pattern)
      : m_global(global), m_system(solvers, solvers->low_precision()),
        m_has_own_factors(solvers->is_independent), m_has_holes(holes > 0)
  {
    if(!m_has_holes) {
      m_global.analyze_pattern(pattern);
      return;
    }
    std::vector<char> is_global(pattern.columns_of_blocks(), true);
    std::fill(is_global.end() - holes, is_global.end(), false);
    m_global_part.set(is_global);
    Block_matrix<2> part;
    m_global_part.take_pattern(pattern, part);
    m_global.analyze_pattern(part);
    m_is_near_holes.assign(is_global.size(), false);
    std::fill(m_is_near_holes.end() - 2 * holes, m_is_near_holes.end(), true);
    add_rings(pattern, rings_of_holes, m_is_near_holes);
  }

  // Factors the two scalar matrices.
  bool set_global_matrix(const Block_matrix<2>& matrix)
  {
    if(!m_has_holes)
      return m_global.set_matrix(matrix);
    Block_matrix<2> part;
    m_global_part.take(matrix, part);
    return m_global.set_matrix(part);
  }

  // Chooses the blocks near which the whole matrix is to be solved, and factors it there. The matrix is referred to by
  // `start()` and `solve()`. Solvers whose copies share their factors have none for this matrix.
  bool set_near_matrix(const Block_matrix<2>& matrix)
  {
    rescale_globally(matrix);
    if(!m_has_own_factors)
      return true;
    m_matrix = &matrix;
    find_strongly_coupled_blocks(matrix, m_coupling, m_is_near);
    if(m_has_holes)
      std::transform(m_is_near.begin(), m_is_near.end(), m_is_near_holes.begin(), m_is_near.begin(),
                     [](char a, char b) { return a || b; });
    m_near_part.set(m_is_near);
    if(!has_near_part())
      return true;
    m_near_part.take(matrix, m_near_matrix);
    return m_system.set_matrix(m_near_matrix);
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
    if(!m_system.solve(m_near_residual, m_near))
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
    if(!m_system.solve(m_near_residual, m_near))
      return false;
    m_near_part.add(m_near, correction);
    return true;
  }

  // Whether low precision was not enough near the blocks
  bool is_repeated() const { return has_near_part() && m_system.is_repeated(); }

private:
  void rescale_globally(const Block_matrix<2>& matrix)
  {
    take_diagonal(matrix, m_diagonal);
    if(m_has_holes)
      m_global_part.take(m_diagonal, m_global_diagonal);
    m_global.rescale(m_has_holes ? m_global_diagonal : m_diagonal);
  }

  bool solve_globally(const Eigen::VectorXd& residual, Eigen::VectorXd& correction)
  {
    if(!m_has_holes)
      return m_global.solve(residual, correction);
    m_global_part.take(residual, m_global_residual);
    if(!m_global.solve(m_global_residual, m_global_correction))
      return false;
    correction = Eigen::VectorXd::Zero(residual.size());
    m_global_part.add(m_global_correction, correction);
    return true;
  }

  Block_preconditioner& m_global;
  Preconditioning_system m_system;
  bool m_has_own_factors, m_has_holes;
  std::vector<char> m_is_near_holes; // these two only with holes
  Part_of_blocks m_global_part;
  Part_of_blocks m_near_part;
  const Block_matrix<2>* m_matrix = nullptr;
  std::vector<double> m_coupling; // from here on what is used again for its memory only
  std::vector<char> m_is_near;
  Block_matrix<2> m_near_matrix;
  Eigen::VectorXd m_near_residual, m_near, m_global_residual, m_global_correction, m_diagonal,
      m_global_diagonal;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEAR_PRECONDITIONER_H
