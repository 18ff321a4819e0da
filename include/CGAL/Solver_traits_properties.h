// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_TRAITS_PROPERTIES_H
#define CGAL_SOLVER_TRAITS_PROPERTIES_H

#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgSolverInterfaceLS

The counterpart of lower precision of a solver. It replaces `SolverTraits` if the factors only precondition an iterative
solution: fewer digits then suffice, which take half of the memory and less time. The counterpart of
`SuperLU_solver_traits<double>` factors definite matrices as `SuperLU_solver_traits<float>` does with the same widths,
with `SuperLU_options::PIVOTS` as its check, and with `SuperLU_options::keep_memory`. It is a type of its own, which
compiles faster. Any other solver is its own counterpart.

This is a customization point: specialize it for a solver of your own, with the members below.

\code{.cpp}
template <>
struct CGAL::Low_precision_solver_traits<My_solver<double>>
{
  typedef My_solver<float> type;
  static type create(const My_solver<double>& traits) { return type(traits.options()); }
};
\endcode

If the counterpart refuses a matrix (by returning `false`), or does not precondition well enough, a copy of the
caller's own object of type `SolverTraits` factors the matrix again.

\tparam SolverTraits a model of `SparseLinearAlgebraTraits_d`

\sa `CGAL::Has_independent_copies<SolverTraits>`
*/
template <class SolverTraits>
struct Low_precision_solver_traits
{
  /// The counterpart, a model of `SparseLinearAlgebraWithFactorTraits_d` if `SolverTraits` is one.
  typedef SolverTraits type;

  /// returns a counterpart of the object `traits`, with the settings of that object.
  static type create(const SolverTraits& traits) { return traits; }
};

/*!
\ingroup PkgSolverInterfaceLS

Whether copies of a solver own their factorizations. They do if
- `factor()` on a copy has no effect on the other copies or on the original object,
- different threads may use different copies at the same time, and
- the matrix may be destroyed after `factor()`.

If so, two copies factor two matrices at the same time. The type is `std::true_type` for
`SuperLU_solver_traits`, and `std::false_type` otherwise: copies of `Eigen_solver_traits` share one solver.

This is a customization point: specialize it for a solver of your own.

\code{.cpp}
template <>
struct CGAL::Has_independent_copies<My_solver<double>> : std::true_type
{};
\endcode

\tparam SolverTraits a model of `SparseLinearAlgebraWithFactorTraits_d`

\sa `CGAL::Low_precision_solver_traits<SolverTraits>`
*/
template <class SolverTraits>
struct Has_independent_copies : std::false_type
{};

} // namespace CGAL

#endif // CGAL_SOLVER_TRAITS_PROPERTIES_H
