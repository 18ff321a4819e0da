// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PRECONDITIONING_SYSTEM_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PRECONDITIONING_SYSTEM_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <Eigen/Core>

#include <memory>
#include <utility>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// A definite system whose solutions are good enough to precondition. It is factored by the counterpart of lower precision of
// the caller's traits, and by a copy of these themselves if that is not enough.
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

  void analyze_pattern(const Diagonal_parts<2>& matrix) { m_low->analyze_pattern(matrix); }

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

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PRECONDITIONING_SYSTEM_H
