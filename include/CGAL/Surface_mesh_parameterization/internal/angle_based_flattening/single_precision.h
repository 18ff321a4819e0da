// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SINGLE_PRECISION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SINGLE_PRECISION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/single_precision_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/symmetric_system.h>

#include <CGAL/SuperLU_solver_traits.h>

#include <Eigen/Core>

#include <array>
#include <optional>
#include <utility>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The system with which those of `SolverTraits` are preconditioned
template <typename SolverTraits>
struct Preconditioning
{
  typedef Symmetric_system<SolverTraits> System;

  static const SolverTraits& traits(const SolverTraits& traits) { return traits; }
};

typedef std::array<Eigen::VectorXd, 2> Two_vectors;

// A definite system that is solved in double precision, even with traits of single precision, for two right-hand sides.
template <typename SolverTraits>
class Definite_system
{
public:
  explicit Definite_system(SolverTraits traits) : m_system(std::move(traits)) {}

  // Returns `false` if the linear solver fails.
  bool solve(const Block_matrix<1>& matrix, const Two_vectors& right_hand_sides, Two_vectors& solutions)
  {
    return m_system.set_matrix(matrix) && m_system.solve(right_hand_sides[0], solutions[0]) &&
           m_system.solve(right_hand_sides[1], solutions[1]);
  }

  bool is_repeated_in_double() const { return false; }

private:
  Symmetric_system<SolverTraits> m_system;
};

// A definite system that is factored in single precision if that suffices, else in double: solutions are good enough to
// precondition.
class Single_precision_system
{
public:
  typedef Single_precision_solver Traits;

  explicit Single_precision_system(Traits traits) : m_single(std::move(traits)) {}

  template <typename Source>
  bool set_matrix(const Source& matrix)
  {
    m_double.reset();
    if(m_single.set_matrix(matrix))
      return true;
    m_double.emplace(SuperLU_solver_traits<double>());
    return m_double->set_matrix(matrix);
  }

  bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution)
  {
    return m_double ? m_double->solve(right_hand_side, solution) : m_single.solve(right_hand_side, solution);
  }

  const Traits& traits() const { return m_single.traits(); }

  // Whether single precision was not enough for the matrix
  bool is_repeated_in_double() const { return m_double.has_value(); }

private:
  Symmetric_system<Traits> m_single;
  std::optional<Symmetric_system<SuperLU_solver_traits<double>>> m_double;
};

template <>
struct Preconditioning<SuperLU_solver_traits<double>>
{
  typedef Single_precision_system System;

  static System::Traits traits(const SuperLU_solver_traits<double>&) { return System::Traits(); }
};

template <>
class Definite_system<Single_precision_solver>
{
  static constexpr int max_steps = 30; // about as long as it takes to factor the matrix in double precision

public:
  explicit Definite_system(Single_precision_solver traits) : m_single(std::move(traits)) {}

  bool solve(const Block_matrix<1>& matrix, const Two_vectors& right_hand_sides, Two_vectors& solutions)
  {
    m_is_repeated = !solve_in_single_precision(matrix, right_hand_sides, solutions);
    return !m_is_repeated || Definite_system<SuperLU_solver_traits<double>>(SuperLU_solver_traits<double>())
                                 .solve(matrix, right_hand_sides, solutions);
  }

  bool is_repeated_in_double() const { return m_is_repeated; }

private:
  bool solve_in_single_precision(const Block_matrix<1>& matrix, const Two_vectors& right_hand_sides,
                                 Two_vectors& solutions)
  {
    if(!m_single.set_matrix(matrix))
      return false;
    const Iterative_accuracy rounding = {1e-15};
    std::array<bool, 2> solved;
    parallel_for(2, [&](int k) {
      solved[k] =
          conjugate_gradients(matrix, right_hand_sides[k], m_single, rounding, max_steps, solutions[k])
              .status == Iterative_solution::SOLVED;
    });
    return solved[0] && solved[1];
  }

  Symmetric_system<Single_precision_solver> m_single;
  bool m_is_repeated = false;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SINGLE_PRECISION_H
