// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves Eq. 16 for the multipliers: by one factorization, as the paper does, or by preconditioned conjugate gradients.
// `newton_system.h` calls it in each iteration. Factors are kept as long as they precondition well.
//
// Definite systems, solved in double precision by factors of lower precision, which take less time and memory, and by
// factors of full precision if that fails. Layouts and predicted scales are such systems.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEWTON_EQUATION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEWTON_EQUATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/newton_preconditioner.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

typedef std::array<Eigen::VectorXd, 2> Two_vectors;

inline bool solve_directly(Linear_solver& solver, const Two_vectors& right_hand_sides, Two_vectors& solutions)
{
  return solver.solve(right_hand_sides[0], solutions[0]) && solver.solve(right_hand_sides[1], solutions[1]);
}

// The solver's factors precondition conjugate gradients. Returns `false` if these are slow.
inline bool solve_iteratively(const Block_matrix<1>& matrix, Linear_solver& solver,
                              const Two_vectors& right_hand_sides, Two_vectors& solutions)
{
  constexpr int max_steps = 30; // about as long as it takes to factor the matrix in double precision
  const Iterative_accuracy rounding = {1e-15};
  std::array<bool, 2> solved;
  const auto solve = [&](int k) {
    solved[k] =
        conjugate_gradients(matrix, right_hand_sides[k], solver, rounding, max_steps, solutions[k]).status ==
        Iterative_solution::SOLVED;
  };
  parallel_for(2, solve, static_cast<int>(right_hand_sides[0].size()));
  return solved[0] && solved[1];
}

// Solves a definite system for two right-hand sides by a solver of low precision, which says afterwards whether that
// was enough (`is_repeated()`). Returns `false` if the solver fails.
inline bool solve_definite(const Block_matrix<1>& matrix, Linear_solver& solver,
                           const Two_vectors& right_hand_sides, Two_vectors& solutions)
{
  if(!solver.set_matrix(matrix))
    return false;
  const bool done = solver.is_to_be_refined() ? solve_iteratively(matrix, solver, right_hand_sides, solutions)
                                              : solve_directly(solver, right_hand_sides, solutions);
  return done || (solver.repeat(matrix) && solve_directly(solver, right_hand_sides, solutions));
}

// Solves Eq. 16 for one Newton step after the other: as a whole, as in the paper, or iteratively, as exactly as asked
// for. The factors of the preconditioner serve for several steps.
class Newton_equation
{
  static constexpr int max_steps = 60;      // about as long as it takes to factor the whole matrix
  static constexpr int steps_too_many = 20; // about as long as it takes to factor the preconditioner

public:
  // Of the matrix of a chart with holes, the last blocks belong to them, as `Bound_matrix` has them.
  Newton_equation(const Linear_solvers& solvers, bool iteratively, int holes = 0)
      : m_solvers(solvers), m_iteratively(iteratively && solvers->keeps_factors()), m_holes(holes)
  {}

  // Prepares the first solution as far as possible without values, to save time.
  void analyze_pattern(const Block_matrix<2>& matrix)
  {
    if(m_iteratively && !m_preconditioner && matrix.size() > 0)
      m_preconditioner.emplace(m_solvers, m_holes, matrix);
  }

  // Solves with a matrix of the same pattern each time. Returns `false` if the linear solver fails.
  bool solve(const Block_matrix<2>& matrix, const Eigen::VectorXd& right_hand_side,
             const Iterative_accuracy& accuracy, Eigen::VectorXd& solution)
  {
    m_accuracy = accuracy;
    m_steps = m_factorizations = m_repeated = 0;
    if(right_hand_side.size() == 0) {
      solution = right_hand_side;
      return true;
    }
    analyze_pattern(matrix);
    if(m_iteratively) {
      const Iterative_solution::Status status = solve_iteratively(matrix, right_hand_side, solution);
      if(status == Iterative_solution::SOLVED)
        return true;
      if(status == Iterative_solution::FAILED && !m_solvers->has_low_precision())
        return false;
    }
    m_iteratively = false;
    m_preconditioner.reset();
    ++m_factorizations;
    if(!m_whole_system)
      m_whole_system = m_solvers->full_precision();
    return m_whole_system->set_matrix(matrix) && m_whole_system->solve(right_hand_side, solution);
  }

  // Whether the next solution begins by factoring the whole matrix, or both scalar ones
  bool is_to_be_factored() const { return !m_iteratively || m_preconditioner_is_stale; }

  // Of the last solution: steps of conjugate gradients, matrices that were factored, and those of them for which low
  // precision was not enough.
  int steps() const { return m_steps; }
  int factorizations() const { return m_factorizations; }
  int repeated_factorizations() const { return m_repeated; }

  // A solver that may know the pattern of the one-rings of the interior vertices, and the holes, already
  std::unique_ptr<Linear_solver> scalar_solver() const
  {
    return m_preconditioner ? m_preconditioner->scalar_solver() : m_solvers->low_precision();
  }

private:
  Iterative_solution::Status solve_iteratively(const Block_matrix<2>& matrix,
                                               const Eigen::VectorXd& right_hand_side,
                                               Eigen::VectorXd& solution)
  {
    bool fresh = m_preconditioner_is_stale;
    if((fresh && !factor_global_matrix(matrix)) || !factor_near_matrix(matrix))
      return Iterative_solution::FAILED;
    for(;; fresh = true) {
      m_vectors.residual = right_hand_side;
      if(!m_preconditioner->start(m_vectors.residual, solution))
        return Iterative_solution::FAILED;
      const Iterative_solution result = conjugate_gradients(matrix, right_hand_side, *m_preconditioner,
                                                            m_accuracy, max_steps, m_vectors, solution);
      m_steps += result.steps;
      m_preconditioner_is_stale = result.steps > steps_too_many;
      if(result.status != Iterative_solution::NOT_SOLVED || fresh)
        return result.status;
      if(!factor_global_matrix(matrix))
        return Iterative_solution::FAILED;
    }
  }

  // The near part is small, and changes the most from step to step.
  bool factor_near_matrix(const Block_matrix<2>& matrix)
  {
    const bool done = m_preconditioner->set_near_matrix(matrix);
    m_factorizations += m_preconditioner->has_near_part();
    m_repeated += m_preconditioner->is_near_repeated();
    return done;
  }

  bool factor_global_matrix(const Block_matrix<2>& matrix)
  {
    const bool done = m_preconditioner->set_global_matrix(matrix);
    m_factorizations += 2;
    m_repeated += m_preconditioner->repeated_global_factorizations();
    return done;
  }

  Linear_solvers m_solvers;
  bool m_iteratively;
  int m_holes;
  std::optional<Newton_preconditioner> m_preconditioner;
  bool m_preconditioner_is_stale = true; // or not there yet
  std::unique_ptr<Linear_solver> m_whole_system;
  Iteration_vectors m_vectors;
  Iterative_accuracy m_accuracy;
  int m_steps = 0, m_factorizations = 0, m_repeated = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_NEWTON_EQUATION_H
