// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Hides the types of the caller's solver traits, and of their counterpart of lower precision, so that numerics are
// compiled only once. Every stage that solves a linear system gets its solvers from here: angles, layouts, seams, cones
// and injective maps.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_LINEAR_SOLVERS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_LINEAR_SOLVERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Solver_traits_properties.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/symmetric_system.h>

#ifdef CGAL_SUPERLU_ENABLED
#include <CGAL/SuperLU_solver_traits.h>
#endif

#include <limits>
#include <memory>
#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The caller's solver traits, and their counterpart of lower precision, behind an interface: the numerics know neither
// type.
class Solver_source
{
public:
  virtual ~Solver_source() = default;
  virtual std::unique_ptr<Linear_solver> full_precision() const = 0;
  virtual std::unique_ptr<Linear_solver> low_precision() const = 0;

  bool keeps_factors = false;     // otherwise it cannot precondition
  bool has_low_precision = false; // the counterpart is another type
  bool is_independent = false;    // two matrices may be factored at the same time
  bool is_to_be_refined = false;  // the counterpart has fewer digits than `double`
  bool may_be_shared = false;     // several threads may solve with the counterpart's factors
};

template <typename SolverTraits>
class Solver_source_of : public Solver_source
{
  typedef Low_precision_solver_traits<SolverTraits> Low_precision;
  typedef typename Low_precision::type Low;

public:
  explicit Solver_source_of(const SolverTraits& traits)
      : m_full(std::make_shared<Analyzed_traits<SolverTraits>>(traits)),
        m_low(std::make_shared<Analyzed_traits<Low>>(Low_precision::create(traits)))
  {
    keeps_factors = Has_factor<SolverTraits>::value;
    has_low_precision = !std::is_same<Low, SolverTraits>::value;
    is_independent = Has_independent_copies<SolverTraits>::value && Has_independent_copies<Low>::value;
    is_to_be_refined = Has_factor<Low>::value &&
                       std::numeric_limits<typename Low::NT>::digits < std::numeric_limits<double>::digits;
    may_be_shared = Has_const_solution<Low>::value;
  }

  std::unique_ptr<Linear_solver> full_precision() const override
  {
    return std::make_unique<Symmetric_system<SolverTraits>>(m_full);
  }

  std::unique_ptr<Linear_solver> low_precision() const override
  {
    return std::make_unique<Symmetric_system<Low>>(m_low);
  }

private:
  std::shared_ptr<Analyzed_traits<SolverTraits>> m_full;
  std::shared_ptr<Analyzed_traits<Low>> m_low;
};

template <typename SolverTraits>
std::shared_ptr<const Solver_source> solver_source(const SolverTraits& traits)
{
  return std::make_shared<Solver_source_of<SolverTraits>>(traits);
}

#if defined(CGAL_ANGLE_BASED_FLATTENING_COMPILED) && defined(CGAL_SUPERLU_TYPES_ARE_HIDDEN)
extern template std::shared_ptr<const Solver_source> solver_source(const SuperLU_solver_traits<>&);
#endif

// The source as a value that is made of any traits
class Linear_solvers
{
public:
  template <typename SolverTraits>
  Linear_solvers(const SolverTraits& traits) : m_source(solver_source(traits))
  {}

  const Solver_source* operator->() const { return m_source.get(); }

private:
  std::shared_ptr<const Solver_source> m_source;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_LINEAR_SOLVERS_H
