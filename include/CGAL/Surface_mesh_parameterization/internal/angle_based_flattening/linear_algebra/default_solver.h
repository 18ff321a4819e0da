// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The solver of programs that name none. Only these need SuperLU: all others compile and link without it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_DEFAULT_SOLVER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_DEFAULT_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <type_traits>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

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

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_DEFAULT_SOLVER_H
