// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_LINEAR_SOLVERS_H
#define ABF_BENCHMARK_LINEAR_SOLVERS_H

// The solvers behind one interface:
//   order(system), factor(system), solve(b, x)  do what they say, and return whether they succeeded;
//   nonzeros()               is the number of entries of the factors;
//   ordering_reused()        whether the last call of factor() did not have to order;
//   seconds_of_order(system) is the time that the first call of factor() spent ordering, where order() does nothing;
//   factors_again            whether it makes a difference that another matrix of the same pattern was factored.

#include <Eigen/SuperLUSupport> // must come before CGAL's traits

#include "Measurement.h"

#include <CGAL/Eigen_sparse_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/SuperLU_solver_traits.h>

#include <Eigen/SparseCholesky>
#ifdef ABF_WITH_CHOLMOD
#include <Eigen/CholmodSupport>
#endif

#include <vector>

namespace ABF_benchmark {

typedef CGAL::Eigen_vector<double> Solution;

// A square matrix that stores both triangles, and a right-hand side, in the types of CGAL's solvers
struct Linear_system
{
  typedef Eigen::SparseMatrix<double> Columns;

  CGAL::Eigen_sparse_matrix<double> matrix{0, 0};
  CGAL::Eigen_vector<double> right_side{0};

  Columns& columns() { return matrix.eigen_object(); }
  const Columns& columns() const { return matrix.eigen_object(); }
  int order() const { return static_cast<int>(columns().rows()); }
};

// SuperLU through `CGAL::SuperLU_solver_traits`
class CGAL_superlu
{
public:
  static constexpr bool factors_again = true;

  bool order(const Linear_system& system) { return m_traits.analyze_pattern(system.matrix); }
  bool factor(const Linear_system& system)
  {
    double denominator = 1;
    return m_traits.factor(system.matrix, denominator);
  }
  bool solve(const Solution& b, Solution& x) { return m_traits.linear_solver(b, x); }
  double nonzeros() const { return static_cast<double>(m_traits.factor_nonzeros()); }
  bool ordering_reused() const { return m_traits.ordering_reused(); }
  double seconds_of_order(const Linear_system&) { return 0; }

private:
  CGAL::SuperLU_solver_traits<double> m_traits;
};

// A direct solver with Eigen's interface
template <class Solver>
class Eigen_engine : protected Solver
{
public:
  static constexpr bool factors_again = true;

  bool order(const Linear_system& system)
  {
    this->analyzePattern(system.columns());
    return true; // factor() would report an error
  }
  bool factor(const Linear_system& system)
  {
    this->factorize(system.columns());
    return this->info() == Eigen::Success;
  }
  bool solve(const Solution& b, Solution& x)
  {
    x.eigen_object() = Solver::solve(b.eigen_object());
    return this->info() == Eigen::Success;
  }
  bool ordering_reused() const { return true; }
  double seconds_of_order(const Linear_system&) { return 0; }
};

// It orders in every factorization. The time of the ordering is measured separately.
class Eigen_superlu : public Eigen_engine<Eigen::SuperLU<Linear_system::Columns>>
{
public:
  static constexpr bool factors_again = false;

  double nonzeros() const
  {
    const double lower = static_cast<const SCformat*>(this->m_sluL.Store)->nnz;
    const double upper = static_cast<const NCformat*>(this->m_sluU.Store)->nnz;
    return lower + upper - this->m_sluL.nrow;
  }

  // What dgssvx() does before it factors
  double seconds_of_order(const Linear_system&)
  {
    std::vector<int> permutation(this->m_sluA.ncol), tree(this->m_sluA.ncol);
    superlu_options_t options;
    set_default_options(&options);
    SuperMatrix ordered;
    const double seconds = seconds_of([&] {
      get_perm_c(COLAMD, &this->m_sluA, permutation.data());
      sp_preorder(&options, &this->m_sluA, permutation.data(), tree.data(), &ordered);
    });
    Destroy_CompCol_Permuted(&ordered);
    return seconds;
  }
};

struct Eigen_ldlt : Eigen_engine<Eigen::SimplicialLDLT<Linear_system::Columns>>
{
  double nonzeros() const { return static_cast<double>(this->m_matrix.nonZeros() + this->m_diag.size()); }
};

#ifdef ABF_WITH_CHOLMOD
struct Cholmod_supernodal : Eigen_engine<Eigen::CholmodSupernodalLLT<Linear_system::Columns>>
{
  double nonzeros() { return this->cholmod().lnz; }
};
#endif

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_LINEAR_SOLVERS_H
