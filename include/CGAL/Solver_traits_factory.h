// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_TRAITS_FACTORY_H
#define CGAL_SOLVER_TRAITS_FACTORY_H

#include <type_traits>
#include <utility>

namespace CGAL {

template <class EigenSolver>
class Eigen_solver_traits;

namespace internal {

// Whether the traits are those of a solver of Eigen's, or derived from these. Their copies share one solver.
template <class EigenSolver>
std::true_type wraps_eigen_solver(const Eigen_solver_traits<EigenSolver>*);
std::false_type wraps_eigen_solver(const void*);

// Solvers of Eigen's that iterate have an accuracy and a limit, which is negative or 0 if nobody has set it.
template <class From, class To>
auto copy_settings_of_iteration(const From& from, To& to, int)
    -> decltype(to.setTolerance(from.tolerance()), to.setMaxIterations(from.maxIterations()), void())
{
  to.setTolerance(from.tolerance());
  if(from.maxIterations() > 0)
    to.setMaxIterations(from.maxIterations());
}

template <class From, class To>
void copy_settings_of_iteration(const From&, To&, long)
{}

} // namespace internal

/*!
\ingroup PkgSolverInterfaceLS

The counterpart of lower precision of a solver. It replaces `SolverTraits` if the factors only precondition an iterative
solution: fewer digits then suffice, which take half of the memory and less time. The counterpart of
`SuperLU_solver_traits<double>` is `SuperLU_solver_traits<float>` with the same widths, and with
`SuperLU_options::PIVOTS` as its check. Any other solver is its own counterpart.

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

\sa `CGAL::Solver_traits_factory<SolverTraits>`
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

How several solvers are made of one, each with factors of its own. Different threads can use them at the same time, to
factor different matrices and to solve with them. All solvers of a run are made like this from the object that the
caller gives.

In general, a new solver is a copy of the given one. So copies must own their factors: calling `factor()` on a copy has
no effect on the others. Copies of `Eigen_solver_traits` share one solver. Of these, and of classes derived from them, a
new solver is default-constructed. From the solver of Eigen that the given object wraps, it takes the tolerance and the
limit of iterations, if there are any. Eigen's solvers tell no other setting.

This is a customization point: specialize it for a solver of your own whose copies share their factors, or for a solver
of Eigen that needs other settings.

\code{.cpp}
template <>
struct CGAL::Solver_traits_factory<My_solver<double>>
{
  static constexpr bool keeps_matrix = true;
  static My_solver<double> create(const My_solver<double>& traits) { return My_solver<double>(traits.options()); }
};
\endcode

\tparam SolverTraits a model of `SparseLinearAlgebraTraits_d`

\sa `CGAL::Low_precision_solver_traits<SolverTraits>`
*/
template <class SolverTraits>
struct Solver_traits_factory
{
  /// Whether a solver may refer to its matrix after `factor()`. Otherwise the matrix is destroyed, to save memory.
  static constexpr bool keeps_matrix = true;

  /// returns a solver with the settings of `traits`.
  static SolverTraits create(const SolverTraits& traits)
  {
    if constexpr(decltype(internal::wraps_eigen_solver(static_cast<const SolverTraits*>(nullptr)))::value) {
      static_assert(
          std::is_default_constructible<SolverTraits>::value,
          "Copies of these traits share one solver of Eigen's: specialize CGAL::Solver_traits_factory.");
      SolverTraits given(traits), result; // `solver()` is not const
      internal::copy_settings_of_iteration(std::as_const(given.solver()), result.solver(), 0);
      return result;
    } else {
      return traits;
    }
  }
};

} // namespace CGAL

#endif // CGAL_SOLVER_TRAITS_FACTORY_H
