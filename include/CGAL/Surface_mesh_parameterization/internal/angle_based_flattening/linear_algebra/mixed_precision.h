// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Definite systems that are factored in lower precision, which takes less time and memory, and in full precision where
// that fails. Preconditioners of Eq. 16 and of injective maps rely on it, and layouts and predicted scales solve by it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_MIXED_PRECISION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_MIXED_PRECISION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/symmetric_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <array>
#include <memory>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A definite system whose solutions are good enough to precondition. It is factored by the counterpart of lower
// precision of the caller's traits, and by a copy of these themselves if that is not enough.
class Preconditioning_system
{
public:
  Preconditioning_system(const Linear_solvers& solvers, std::unique_ptr<Linear_solver> low)
      : m_solvers(solvers), m_low(std::move(low))
  {}

  // Returns `false` if the matrix cannot be factored.
  template <typename Source>
  bool set_matrix(const Source& matrix)
  {
    m_full.reset();
    if(m_low->set_matrix(matrix))
      return true;
    if(!m_solvers->has_low_precision)
      return false;
    m_full = m_solvers->full_precision();
    return m_full->set_matrix(matrix);
  }

  void analyze_pattern(const Block_matrix<2>& blocks) { m_low->analyze_pattern(blocks); }

  bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution)
  {
    return m_full ? m_full->solve(right_hand_side, solution) : m_low->solve(right_hand_side, solution);
  }

  // A solver that may know the pattern already
  std::unique_ptr<Linear_solver> low_precision_solver() const { return m_low->copy(); }

  // Whether low precision was not enough for the matrix
  bool is_repeated() const { return m_full != nullptr; }

private:
  Linear_solvers m_solvers;
  std::unique_ptr<Linear_solver> m_low, m_full;
};

typedef std::array<Eigen::VectorXd, 2> Two_vectors;

// A definite system, solved in double precision for two right-hand sides. The counterpart of lower precision of the
// caller's traits preconditions conjugate gradients; where these are slow, a copy of the caller's traits solves the
// system.
class Definite_system
{
  static constexpr int max_steps = 30; // about as long as it takes to factor the matrix in double precision

public:
  Definite_system(const Linear_solvers& solvers, std::unique_ptr<Linear_solver> low)
      : m_solvers(solvers), m_low(std::move(low))
  {}

  // Returns `false` if the linear solver fails.
  bool solve(const Block_matrix<1>& matrix, const Two_vectors& right_hand_sides, Two_vectors& solutions)
  {
    m_is_repeated = false;
    if(m_low->set_matrix(matrix) &&
       (m_solvers->is_to_be_refined ? solve_iteratively(matrix, right_hand_sides, solutions)
                                    : solve_directly(*m_low, right_hand_sides, solutions)))
      return true;
    if(!m_solvers->has_low_precision)
      return false;
    m_is_repeated = true;
    const std::unique_ptr<Linear_solver> full = m_solvers->full_precision();
    return full->set_matrix(matrix) && solve_directly(*full, right_hand_sides, solutions);
  }

  // Whether low precision was not enough for the matrix
  bool is_repeated() const { return m_is_repeated; }

private:
  static bool solve_directly(Linear_solver& system, const Two_vectors& right_hand_sides,
                             Two_vectors& solutions)
  {
    return system.solve(right_hand_sides[0], solutions[0]) && system.solve(right_hand_sides[1], solutions[1]);
  }

  bool solve_iteratively(const Block_matrix<1>& matrix, const Two_vectors& right_hand_sides,
                         Two_vectors& solutions)
  {
    const Iterative_accuracy rounding = {1e-15};
    std::array<bool, 2> solved;
    const auto solve = [&](int k) {
      solved[k] = conjugate_gradients(matrix, right_hand_sides[k], *m_low, rounding, max_steps, solutions[k])
                      .status == Iterative_solution::SOLVED;
    };
    if(m_solvers->may_be_shared) {
      parallel_for(2, solve, static_cast<int>(right_hand_sides[0].size()));
    } else {
      solve(0);
      solve(1);
    }
    return solved[0] && solved[1];
  }

  Linear_solvers m_solvers;
  std::unique_ptr<Linear_solver> m_low;
  bool m_is_repeated = false;
};
} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_MIXED_PRECISION_H
