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

Names the solver that factors in the place of `SolverTraits` where the factors only precondition an iterative solution, so
that fewer digits, half of the memory and less time are enough. For `SuperLU_solver_traits<double>` it is
`SuperLU_solver_traits<float>`, with the same widths, and with `SuperLU_options::PIVOTS` as its check; any other solver
is its own counterpart.

This is a customization point: specialize it for a solver of your own, with the members below.

\code{.cpp}
template <>
struct CGAL::Low_precision_solver_traits<My_solver<double>>
{
  typedef My_solver<float> type;
  static type create(const My_solver<double>& traits) { return type(traits.options()); }
};
\endcode

What the counterpart refuses (by returning `false`), or does not precondition well enough, has to be done again by a copy of the
caller's own object of type `SolverTraits`.

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

Says whether copies of a solver own their factorizations:
- `factor()` on a copy has no effect on the other copies, nor on the object that they are copies of;
- different threads may use different copies at the same time;
- the matrix may be destroyed after `factor()`.

If so, two matrices are factored at the same time, each by a copy. It is `std::true_type` for
`SuperLU_solver_traits`, and otherwise `std::false_type`: copies of `Eigen_solver_traits` share one solver.

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
