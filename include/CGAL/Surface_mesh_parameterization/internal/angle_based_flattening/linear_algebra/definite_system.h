// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Definite systems, solved in double precision by factors of lower precision, which take less time and memory, and by
// factors of full precision if that fails. Layouts and predicted scales are such systems.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_DEFINITE_SYSTEM_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_DEFINITE_SYSTEM_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <array>

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

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_DEFINITE_SYSTEM_H
