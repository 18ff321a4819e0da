// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// A factorization that either solves accurately or says that it cannot: tests for singularity, signs of pivots,
// refinement. `SuperLU_solver_traits.h` keeps one per solver, and shares it between copies.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORIZATION_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORIZATION_H

#include <CGAL/Solver_interface/internal/SuperLU_analysis.h>
#include <CGAL/Solver_interface/internal/SuperLU_factors.h>
#include <CGAL/Solver_interface/internal/SuperLU_matrix.h>
#include <CGAL/SuperLU_options.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

namespace CGAL {
namespace internal {
inline namespace CGAL_SUPERLU_TYPES {

// A checked factorization. It refuses singular matrices, never takes an indefinite matrix for a definite one, and
// refines solutions if necessary. Once `factor()` has returned `FACTORED` the object does not change any more. Copies
// of a solver and threads can share it.
template <class FT>
class SuperLU_factorization
{
  typedef SuperLU_matrix<FT> Columns;
  typedef Eigen::Matrix<FT, Eigen::Dynamic, 1> Vector;
  typedef SuperLU_tolerances<FT> Tolerances;

public:
  typedef typename SuperLU_factors<FT>::Block Block;

  SuperLU_factorization(std::shared_ptr<const SuperLU_analysis> analysis, const SuperLU_options& options)
      : m_factors(std::move(analysis)), m_options(options)
  {}

  bool is_symmetric() const { return m_factors.is_symmetric(); }
  int size() const { return m_factors.size(); }
  std::size_t nonzeros() const { return m_factors.nonzeros(); }

  enum Result
  {
    FACTORED,
    NOT_DEFINITE,
    FAILED
  };

  // Factors a matrix with the analyzed pattern. The matrix is not needed afterwards. `sign` is the sign of the pivots
  // in symmetric mode.
  Result factor(const Columns& a, FT sign)
  {
    if(!is_symmetric())
      return factor_scaled(a);
    return m_options.check == SuperLU_options::PIVOTS ? factor_by_pivots(a, sign) : factor_definite(a, sign);
  }

  // Replaces the columns of `b` by the solutions. Returns `false` if they are not finite or not accurate.
  bool solve(Block b) const
  {
    SuperLU_scaling::scale(b, m_scaling.row);
    if(!solve_scaled(b))
      return false;
    SuperLU_scaling::scale(b, m_scaling.column);
    return superlu_largest(b.data(), b.size()) < infinity;
  }

private:
  static constexpr FT precision = std::numeric_limits<FT>::epsilon();
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr int refinement_steps = 5;

  // Keeps the lower factor of a matrix that its pivots tell to be definite.
  Result factor_by_pivots(const Columns& a, FT sign)
  {
    // smaller pivots may be rounding errors, so their sign means nothing
    if(!m_factors.factor(a, m_options) || !m_factors.pivots_have_sign(sign) ||
       !(least_pivot_by_diagonal(a) > 16 * precision))
      return NOT_DEFINITE;
    m_factors.keep_lower_factor_only();
    return FACTORED;
  }

  // A matrix that may differ from a singular one by rounding errors only has a small eigenvalue, and so a small pivot.
  Result factor_definite(const Columns& a, FT sign)
  {
    if(!m_factors.factor(a, m_options))
      return NOT_DEFINITE;
    const bool definite = m_factors.pivots_have_sign(sign);
    const bool is_suspicious =
        !Tolerances::pivots_show_singularity || !(least_pivot_by_diagonal(a) > Tolerances::suspicious_pivot);
    if(definite)
      m_factors.keep_lower_factor_only();
    if(is_suspicious && !(least_scaled_eigenvalue(a) > precision))
      return FAILED;
    return definite && is_accurate(a) ? FACTORED : NOT_DEFINITE;
  }

  Result factor_scaled(const Columns& a)
  {
    Columns scaled = a;
    m_scaling.equilibrate(scaled);
    const auto one = [](int) { return FT(1); };
    const bool good = m_scaling.keeps_digits(a) && m_factors.factor(scaled, m_options) &&
                      m_factors.least_relative_pivot(one) > 64 * precision &&
                      (Tolerances::pivots_show_singularity || !is_ill_conditioned(scaled)) &&
                      is_accurate(scaled);
    return good ? FACTORED : FAILED;
  }

  FT least_pivot_by_diagonal(const Columns& a) const
  {
    return m_factors.least_relative_pivot([&](int i) { return superlu_absolute_diagonal(a, i); });
  }

  bool is_ill_conditioned(const Columns& a) const
  {
    FT norm = 0;
    for(int j = 0; j < a.cols(); ++j)
      norm = (std::max)(norm, a.col(j).cwiseAbs().sum());
    return !(m_factors.reciprocal_condition(norm) > precision);
  }

  // The least absolute eigenvalue of the factored symmetric matrix, scaled to a unit diagonal; 0 if it is NaN.
  // Inverse iteration gives an upper bound, which is closer the more singular the matrix is. Unlike the condition
  // number, it does not depend on scaling.
  FT least_scaled_eigenvalue(const Columns& a) const
  {
    Vector root(size()), x = test_vector();
    for(int i = 0; i < size(); ++i)
      root[i] = std::sqrt(superlu_absolute_diagonal(a, i));
    x.array() *= root.array();
    FT growth = x.stableNorm();
    for(int step = 0; step < 3; ++step) {
      x.array() = x.array() / growth * root.array();
      if(!solve_with_factors(x))
        return 0;
      x.array() *= root.array();
      growth = x.stableNorm();
      if(!std::isfinite(growth) || growth == 0)
        return 0;
    }
    return 1 / growth;
  }

  // Not constant, and not orthogonal to a constant vector, which Laplacians nearly map to zero
  Vector test_vector() const
  {
    return Vector::NullaryExpr(size(), [](Eigen::Index i) { return static_cast<FT>(1. + (i % 7) / 7.); });
  }

  // Solves one system to find out whether solutions need refinement. If they do, keeps the matrix.
  bool is_accurate(const Columns& a)
  {
    const Vector b = a * test_vector();
    Vector x = b;
    if(!solve_with_factors(x))
      return false;
    if(residual(a, b, x) <= Tolerances::good_residual)
      return true;
    m_matrix = std::make_unique<const Columns>(a);
    return refine(b, x);
  }

  bool solve_with_factors(Vector& x) const { return m_factors.solve(Block(x.data(), x.size(), 1)); }

  bool solve_scaled(Block b) const
  {
    if(m_matrix == nullptr)
      return m_factors.solve(b);
    for(Eigen::Index k = 0; k < b.cols(); ++k) {
      const Vector right_side = b.col(k);
      Vector x = right_side;
      if(!solve_with_factors(x) || !refine(right_side, x))
        return false;
      b.col(k) = x;
    }
    return true;
  }

  // The backward error of the solution in the maximum norm; infinity instead of NaN. For badly scaled matrices, the
  // product of norms exceeds the range of float.
  static double residual(const Columns& a, const Vector& b, const Vector& x)
  {
    const auto largest = [](const Vector& vector) { return superlu_largest(vector.data(), vector.size()); };
    const double error = largest(a * x - b),
                 scale = largest(a.cwiseAbs() * Vector::Ones(a.cols())) * largest(x) + largest(b);
    if(!std::isfinite(error) || !std::isfinite(scale))
      return infinity;
    return scale > 0 ? error / scale : 0.;
  }

  bool refine(const Vector& b, Vector& x) const
  {
    double error = residual(*m_matrix, b, x);
    for(int step = 0; step < refinement_steps && error > Tolerances::good_residual && std::isfinite(error);
        ++step) {
      Vector candidate = b - *m_matrix * x;
      if(!solve_with_factors(candidate))
        return false;
      candidate += x;
      const double candidate_error = residual(*m_matrix, b, candidate);
      if(!(candidate_error < error))
        break;
      x = std::move(candidate);
      error = candidate_error;
    }
    return error <= Tolerances::fair_residual;
  }

  SuperLU_factors<FT> m_factors;
  SuperLU_options m_options;
  SuperLU_scaling m_scaling;
  std::unique_ptr<const Columns> m_matrix; // the scaled matrix, if refinement is needed
};

} // namespace CGAL_SUPERLU_TYPES
} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORIZATION_H
