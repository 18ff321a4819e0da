// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SINGLE_PRECISION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SINGLE_PRECISION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/symmetric_system.h>

#include <CGAL/SuperLU_solver_traits.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <optional>
#include <utility>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// A definite system that is factored in single precision if that suffices, else in double. Single precision takes half of
// the memory and two thirds of the time; its solutions are good enough to precondition.
class Single_precision_system
{
public:
  typedef SuperLU_solver_traits<float> Traits;

  explicit Single_precision_system(Traits traits) : m_single(std::move(traits)) {}

  bool set_matrix(const Eigen::SparseMatrix<double>& matrix)
  {
    m_double.reset();
    return m_single.set_matrix(matrix) || set_matrix_in_double(matrix);
  }

  bool set_matrix_in_double(const Eigen::SparseMatrix<double>& matrix)
  {
    m_double.emplace(SuperLU_solver_traits<double>());
    return m_double->set_matrix(matrix);
  }

  bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution)
  {
    if(m_double)
      return m_double->solve(right_hand_side, solution);
    const double scale = right_hand_side.cwiseAbs().maxCoeff(); // small residuals must not vanish
    if(!m_single.solve(right_hand_side / (scale > 0 ? scale : 1), solution))
      return false;
    solution *= scale;
    return true;
  }

  bool is_single() const { return !m_double; }
  const Traits& traits() const { return m_single.traits(); }

private:
  Symmetric_system<Traits> m_single;
  std::optional<Symmetric_system<SuperLU_solver_traits<double>>> m_double;
};

// The system with which those of `SolverTraits` are preconditioned
template <typename SolverTraits>
struct Preconditioning
{
  typedef Symmetric_system<SolverTraits> System;

  static const SolverTraits& traits(const SolverTraits& traits) { return traits; }
};

template <>
struct Preconditioning<SuperLU_solver_traits<double>>
{
  typedef Single_precision_system System;

  static System::Traits traits(const SuperLU_solver_traits<double>&) { return System::Traits(); }
};

// A definite system that is solved in double precision, even with traits of single precision.
template <typename SolverTraits>
class Definite_system : public Symmetric_system<SolverTraits>
{
public:
  using Symmetric_system<SolverTraits>::Symmetric_system;
};

template <>
class Definite_system<SuperLU_solver_traits<float>>
{
  static constexpr int max_steps = 30; // about as long as it takes to factor the matrix in double precision

public:
  explicit Definite_system(SuperLU_solver_traits<float> traits) : m_system(std::move(traits)) {}

  // `matrix` must stay.
  bool set_matrix(const Eigen::SparseMatrix<double>& matrix)
  {
    m_matrix = &matrix;
    return m_system.set_matrix(matrix);
  }

  bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution)
  {
    const Iterative_accuracy rounding = {1e-15};
    if(m_system.is_single()) {
      if(conjugate_gradients(*m_matrix, right_hand_side, m_system, rounding, max_steps, solution).status ==
         Iterative_solution::SOLVED)
        return true;
      if(!m_system.set_matrix_in_double(*m_matrix))
        return false;
    }
    return m_system.solve(right_hand_side, solution);
  }

private:
  const Eigen::SparseMatrix<double>* m_matrix = nullptr;
  Single_precision_system m_system;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SINGLE_PRECISION_H
