// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PRECONDITIONING_SYSTEM_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PRECONDITIONING_SYSTEM_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Solver_traits_properties.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/symmetric_system.h>

#include <Eigen/Core>

#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

template <typename SolverTraits>
using Low_precision_traits = typename Low_precision_solver_traits<SolverTraits>::type;

// A definite system whose solutions are good enough to precondition. It is factored by the counterpart of lower precision of
// the caller's traits, and by a copy of these themselves if that is not enough.
template <typename SolverTraits>
class Preconditioning_system
{
  typedef Low_precision_traits<SolverTraits> Low;

public:
  // Different objects may be used by different threads.
  static constexpr bool is_independent =
      Has_independent_copies<SolverTraits>::value && Has_independent_copies<Low>::value;

  Preconditioning_system(const SolverTraits& traits, Low low) : m_traits(traits), m_low(std::move(low)) {}

  // Returns `false` if the matrix cannot be factored.
  template <typename Source>
  bool set_matrix(const Source& matrix)
  {
    m_full.reset();
    if(m_low.set_matrix(matrix))
      return true;
    if(std::is_same<Low, SolverTraits>::value)
      return false;
    m_full.emplace(m_traits);
    return m_full->set_matrix(matrix);
  }

  template <typename Source>
  void analyze_pattern(const Source& matrix)
  {
    m_low.analyze_pattern(matrix);
  }

  bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution)
  {
    return m_full ? m_full->solve(right_hand_side, solution) : m_low.solve(right_hand_side, solution);
  }

  const SolverTraits& traits() const { return m_traits; }
  const Low& low_precision_traits() const { return m_low.traits(); }

  // Whether low precision was not enough for the matrix
  bool is_repeated() const { return m_full.has_value(); }

private:
  const SolverTraits m_traits;
  Symmetric_system<Low> m_low;
  std::optional<Symmetric_system<SolverTraits>> m_full;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PRECONDITIONING_SYSTEM_H
