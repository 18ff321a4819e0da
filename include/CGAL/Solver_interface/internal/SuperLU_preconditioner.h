// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The counterpart of lower precision of `SuperLU_solver_traits<double>`. It solves like `SuperLU_solver_traits<float>`
// with the check `SuperLU_options::PIVOTS`, but has no code for other checks and other matrices: every program would
// compile that, and none would call it.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_PRECONDITIONER_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_PRECONDITIONER_H

#include <CGAL/Eigen_vector.h>
#include <CGAL/Solver_interface/internal/SuperLU_analysis.h>
#include <CGAL/Solver_interface/internal/SuperLU_factors.h>
#include <CGAL/Solver_interface/internal/SuperLU_flag.h>
#include <CGAL/Solver_interface/internal/SuperLU_input.h>
#include <CGAL/Solver_interface/internal/SuperLU_pivots.h>
#include <CGAL/Solver_interface/internal/SuperLU_sparse_matrix.h>
#include <CGAL/SuperLU_options.h>

#include <limits>
#include <memory>
#include <new>

namespace CGAL {
namespace internal {
inline namespace CGAL_SUPERLU_TYPES {

// A model of `SparseLinearAlgebraWithFactorTraits_d` for definite matrices. All others are refused, and so are those
// that store one triangle only. Copies share the factors, which never change, and the memory for later ones.
template <class FT>
class SuperLU_preconditioner
{
  typedef SuperLU_factors<FT> Factors;
  typedef SuperLU_matrix<FT> Columns;

public:
  typedef FT NT;
  typedef CGAL::Eigen_vector<NT> Vector;
  typedef SuperLU_sparse_matrix<NT> Matrix;

  explicit SuperLU_preconditioner(const SuperLU_options& options)
      : m_options(options), m_memory(std::make_shared<typename Factors::Spare_memory>())
  {}

  bool linear_solver(const Matrix& A, const Vector& B, Vector& X, NT& D)
  {
    return factor(A, D) && linear_solver(B, X);
  }

  // Computes the ordering for matrices with the pattern of `A`.
  bool analyze_pattern(const Matrix& A)
  {
    try {
      FT sign = 1;
      return analyze(A.eigen_object(), sign);
    } catch(const std::bad_alloc&) {
      return false;
    }
  }

  bool factor(const Matrix& A, NT& D)
  {
    D = 1;
    m_factors.reset();
    m_lacks_memory.set(false);
    try {
      const Columns& a = A.eigen_object();
      FT sign = 1;
      if(!analyze(a, sign))
        return false;
      const std::shared_ptr<Factors> factors = std::make_shared<Factors>(m_analysis, m_memory);
      if(!superlu_factor_by_pivots(*factors, a, m_options, sign))
        return false;
      m_factors = factors;
      return true;
    } catch(const std::bad_alloc&) {
      m_lacks_memory.set(true);
      return false;
    }
  }

  bool linear_solver(const Vector& B, Vector& X) const
  {
    const typename Vector::EigenType& b = B.eigen_object();
    if(m_factors == nullptr || b.rows() != m_factors->size() || !b.allFinite())
      return false;
    try {
      typename Vector::EigenType& x = X.eigen_object();
      x = b;
      m_factors->solve_with_lower_factor(typename Factors::Block(x.data(), x.rows(), 1));
      return superlu_largest(x.data(), x.size()) < std::numeric_limits<double>::infinity();
    } catch(const std::bad_alloc&) {
      m_lacks_memory.set(true);
      return false;
    }
  }

  // As of `SuperLU_solver_traits`
  bool lacks_memory() const { return m_lacks_memory.get(); }

private:
  // Returns `false` if the matrix is not definite. Keeps the ordering if the pattern was analyzed before.
  bool analyze(const Columns& a, FT& sign)
  {
    if(!superlu_is_well_formed(a) || !superlu_may_be_definite(a, sign))
      return false;
    if(m_analysis == nullptr || !m_analysis->has_pattern_of(a)) {
      m_analysis.reset();
      m_analysis = Factors::analyze(a, true, m_options);
    }
    return true;
  }

  SuperLU_options m_options;
  std::shared_ptr<const Factors> m_factors;
  std::shared_ptr<const SuperLU_analysis> m_analysis;
  std::shared_ptr<typename Factors::Spare_memory> m_memory; // shared with copies
  SuperLU_flag m_lacks_memory;
};

} // namespace CGAL_SUPERLU_TYPES
} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_PRECONDITIONER_H
