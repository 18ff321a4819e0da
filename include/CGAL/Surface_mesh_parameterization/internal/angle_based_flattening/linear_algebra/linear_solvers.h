// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Hides the types of the caller's solver traits, and of their counterpart of lower precision, so that numerics are
// compiled only once. Every stage that solves a linear system gets its solvers from here: angles, layouts, seams, cones
// and injective maps.
//
// The solver of programs that name none. Only these need SuperLU: all others compile and link without it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_LINEAR_SOLVERS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_LINEAR_SOLVERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Solver_traits_factory.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>

#include <CGAL/Named_function_parameters.h>

#include <type_traits>

#ifdef CGAL_SUPERLU_ENABLED
#include <CGAL/SuperLU_solver_traits.h>
#endif

#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Makes solvers of the caller's traits, and of their counterpart of lower precision, for numerics that know neither
// type. Solvers of low precision factor what they refuse in full precision.
class Solver_source
{
public:
  virtual ~Solver_source() = default;
  virtual std::unique_ptr<Linear_solver> full_precision() const = 0;
  virtual std::unique_ptr<Linear_solver> low_precision() const = 0;

  virtual bool keeps_factors() const = 0;     // otherwise they cannot precondition
  virtual bool has_low_precision() const = 0; // the counterpart is another type
};

template <typename SolverTraits>
class Solver_source_of : public Solver_source
{
  typedef Low_precision_solver_traits<SolverTraits> Low_precision;
  typedef typename Low_precision::type Low;
  typedef Analyzed_traits<SolverTraits> Full_traits;
  typedef Analyzed_traits<Low> Low_traits;

public:
  explicit Solver_source_of(const SolverTraits& traits)
      : m_full(std::make_shared<Full_traits>(traits)),
        m_low(std::make_shared<Low_traits>(Low_precision::create(traits)))
  {}

  std::unique_ptr<Linear_solver> full_precision() const override { return full_precision_of(m_full); }

  std::unique_ptr<Linear_solver> low_precision() const override
  {
    if(!has_low_precision())
      return std::make_unique<Symmetric_system<Low>>(m_low);
    return std::make_unique<Symmetric_system<Low>>(m_low,
                                                   [full = m_full] { return full_precision_of(full); });
  }

  bool keeps_factors() const override { return Has_factor<SolverTraits>::value; }
  bool has_low_precision() const override { return !std::is_same<Low, SolverTraits>::value; }

private:
  static std::unique_ptr<Linear_solver> full_precision_of(std::shared_ptr<Full_traits> traits)
  {
    return std::make_unique<Symmetric_system<SolverTraits>>(std::move(traits));
  }

  std::shared_ptr<Full_traits> m_full;
  std::shared_ptr<Low_traits> m_low;
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

// `User` is whatever asks for the default: without SuperLU, the error is where that is instantiated, and nowhere else.
template <typename User>
struct Default_solver_traits
{
#ifdef CGAL_SUPERLU_ENABLED
  typedef SuperLU_solver_traits<> type;
#else
  static_assert(
      std::is_void<User>::value,
      "The default solver of linear systems needs SuperLU: link with the CMake target CGAL::SuperLU_support, "
      "or name another solver, such as CGAL::Eigen_solver_traits.");
#endif
};

// The solvers that the named parameters give, or the default ones
template <typename NamedParameters>
Linear_solvers linear_solvers(const NamedParameters& np)
{
  typedef internal_np::sparse_linear_solver_t Parameter;
  if constexpr(parameters::is_default_parameter<NamedParameters, Parameter>::value) {
    (void)np;
    return Linear_solvers(typename Default_solver_traits<NamedParameters>::type());
  } else {
    return Linear_solvers(parameters::get_parameter(np, internal_np::sparse_linear_solver));
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_LINEAR_SOLVERS_H
