// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FUNCTIONS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FUNCTIONS_H

#include <CGAL/Solver_interface/internal/SuperLU_headers.h>

namespace CGAL {
namespace internal {

// The functions of SuperLU that differ by the number type, and what it calls that type.
template <class FT>
struct SuperLU_functions;

template <>
struct SuperLU_functions<double>
{
  static constexpr superlu::Dtype_t number_type = superlu::SLU_D;
  static constexpr auto factor = &superlu::dgstrf;
  static constexpr auto solve = &superlu::dgstrs;
  static constexpr auto estimate_condition = &superlu::dgscon;
};

#ifdef CGAL_SUPERLU_HAS_SINGLE_PRECISION
template <>
struct SuperLU_functions<float>
{
  static constexpr superlu::Dtype_t number_type = superlu::SLU_S;
  static constexpr auto factor = &superlu::sgstrf;
  static constexpr auto solve = &superlu::sgstrs;
  static constexpr auto estimate_condition = &superlu::sgscon;
};
#endif

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FUNCTIONS_H
