// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DEFINITE_SYSTEM_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DEFINITE_SYSTEM_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/preconditioning_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/symmetric_system.h>

#include <Eigen/Core>

#include <array>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

typedef std::array<Eigen::VectorXd, 2> Two_vectors;

// A definite system, solved in double precision for two right-hand sides. The counterpart of lower precision of the caller's
// traits preconditions conjugate gradients; where these are slow, a copy of the caller's traits solves the system.
template <typename SolverTraits>
class Definite_system
{
  typedef Low_precision_traits<SolverTraits> Low;

  static constexpr int max_steps = 30; // about as long as it takes to factor the matrix in double precision
  static constexpr bool is_iterative =
      Has_factor<Low>::value &&
      std::numeric_limits<typename Low::NT>::digits < std::numeric_limits<double>::digits;

public:
  Definite_system(const SolverTraits& traits, Low low) : m_traits(traits), m_low(std::move(low)) {}

  // Returns `false` if the linear solver fails.
  bool solve(const Block_matrix<1>& matrix, const Two_vectors& right_hand_sides, Two_vectors& solutions)
  {
    m_is_repeated = false;
    if(m_low.set_matrix(matrix) && (is_iterative ? solve_iteratively(matrix, right_hand_sides, solutions)
                                                 : solve_directly(m_low, right_hand_sides, solutions)))
      return true;
    if(std::is_same<Low, SolverTraits>::value)
      return false;
    m_is_repeated = true;
    Symmetric_system<SolverTraits> full(m_traits);
    return full.set_matrix(matrix) && solve_directly(full, right_hand_sides, solutions);
  }

  // Whether low precision was not enough for the matrix
  bool is_repeated() const { return m_is_repeated; }

private:
  template <typename System>
  static bool solve_directly(System& system, const Two_vectors& right_hand_sides, Two_vectors& solutions)
  {
    return system.solve(right_hand_sides[0], solutions[0]) && system.solve(right_hand_sides[1], solutions[1]);
  }

  bool solve_iteratively(const Block_matrix<1>& matrix, const Two_vectors& right_hand_sides,
                         Two_vectors& solutions)
  {
    const Iterative_accuracy rounding = {1e-15};
    std::array<bool, 2> solved;
    const auto solve = [&](int k) {
      solved[k] =
          conjugate_gradients(matrix, right_hand_sides[k], m_low, rounding, max_steps, solutions[k]).status ==
          Iterative_solution::SOLVED;
    };
    if(Has_const_solution<Low>::value) {
      parallel_for(2, solve);
    } else {
      solve(0);
      solve(1);
    }
    return solved[0] && solved[1];
  }

  const SolverTraits m_traits;
  Symmetric_system<Low> m_low;
  bool m_is_repeated = false;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DEFINITE_SYSTEM_H
