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
#include <CGAL/Solver_interface/internal/SuperLU_input.h>
#include <CGAL/Solver_interface/internal/SuperLU_pivots.h>
#include <CGAL/Solver_interface/internal/SuperLU_scaling.h>
#include <CGAL/Solver_interface/internal/SuperLU_tolerances.h>
#include <CGAL/SuperLU_options.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

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
  typedef std::vector<FT> Vector;
  typedef SuperLU_tolerances<FT> Tolerances;

public:
  typedef typename SuperLU_factors<FT>::Block Block;

  typedef typename SuperLU_factors<FT>::Spare_memory Spare_memory;

  SuperLU_factorization(std::shared_ptr<const SuperLU_analysis> analysis, const SuperLU_options& options,
                        std::shared_ptr<Spare_memory> memory)
      : m_factors(std::move(analysis), std::move(memory)), m_options(options)
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
    if(m_options.check == SuperLU_options::PIVOTS)
      return superlu_factor_by_pivots(m_factors, a, m_options, sign) ? FACTORED : NOT_DEFINITE;
    return is_symmetric() ? factor_definite(a, sign) : factor_scaled(a);
  }

  // Replaces the columns of `b` by the solutions. Returns `false` if they are not finite or not accurate.
  bool solve(Block b) const
  {
    m_scaling.scale_rows(b);
    if(!solve_scaled(b))
      return false;
    m_scaling.scale_columns(b);
    return superlu_largest(b.data(), b.size()) < infinity;
  }

private:
  static constexpr FT precision = std::numeric_limits<FT>::epsilon();
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr int refinement_steps = 5;

  Result factor_definite(const Columns& a, FT sign)
  {
    if(!m_factors.factor(a, m_options))
      return NOT_DEFINITE;
    const bool definite = superlu_pivots_have_sign(m_factors, sign);
    if constexpr(Tolerances::pivots_show_singularity) {
      if(has_suspicious_pivot(a) && is_ill_conditioned(a))
        return FAILED;
    }
    if(definite)
      m_factors.keep_lower_factor_only();
    if constexpr(!Tolerances::pivots_show_singularity) {
      if(!(least_scaled_eigenvalue(a) > precision))
        return FAILED;
    }
    return definite && is_accurate(a) ? FACTORED : NOT_DEFINITE;
  }

  Result factor_scaled(const Columns& a)
  {
    Columns scaled = a;
    m_scaling.equilibrate(scaled);
    const FT significant = 64 * precision;
    const bool good = m_scaling.keeps_digits(a) && m_factors.factor(scaled, m_options) &&
                      superlu_least_relative_pivot(m_factors, [](int) { return FT(1); }) > significant &&
                      (Tolerances::pivots_show_singularity || !is_ill_conditioned(scaled)) &&
                      is_accurate(scaled);
    return good ? FACTORED : FAILED;
  }

  // Whether a symmetric matrix may differ from a singular one by rounding errors only. A singular matrix has a pivot
  // that consists of rounding errors, so the condition number is estimated only if a pivot is small.
  bool has_suspicious_pivot(const Columns& a) const
  {
    return !(superlu_least_relative_pivot(m_factors, a) > Tolerances::suspicious_pivot);
  }

  bool is_ill_conditioned(const Columns& a) const
  {
    FT norm = 0;
    for(int j = 0; j < a.cols(); ++j) {
      FT sum = 0;
      for(int k = a.outerIndexPtr()[j]; k < a.outerIndexPtr()[j + 1]; ++k)
        sum += std::abs(a.valuePtr()[k]);
      norm = (std::max)(norm, sum);
    }
    return !(m_factors.reciprocal_condition(norm) > precision);
  }

  static double largest(const Vector& x)
  {
    return superlu_largest(x.data(), static_cast<std::ptrdiff_t>(x.size()));
  }

  // Squares must not leave the range of the numbers.
  static FT norm(const Vector& x)
  {
    const double scale = largest(x);
    double sum = 0;
    for(FT value : x)
      sum += (value / scale) * (value / scale);
    return static_cast<FT>(scale > 0 && std::isfinite(scale) ? scale * std::sqrt(sum) : scale);
  }

  // The least absolute eigenvalue of the factored symmetric matrix, scaled to a unit diagonal; 0 if it is NaN.
  // Inverse iteration gives an upper bound, which is closer the more singular the matrix is. Unlike the condition
  // number, it does not depend on scaling.
  FT least_scaled_eigenvalue(const Columns& a) const
  {
    Vector root(size()), x = test_vector();
    for(int i = 0; i < size(); ++i)
      x[i] *= root[i] = std::sqrt(superlu_absolute_diagonal(a, i));
    FT growth = norm(x);
    for(int step = 0; step < 3; ++step) {
      for(int i = 0; i < size(); ++i)
        x[i] = x[i] / growth * root[i];
      if(!solve_with_factors(x))
        return 0;
      for(int i = 0; i < size(); ++i)
        x[i] *= root[i];
      growth = norm(x);
      if(!std::isfinite(growth) || growth == 0)
        return 0;
    }
    return 1 / growth;
  }

  // Not constant, and not orthogonal to a constant vector, which Laplacians nearly map to zero
  Vector test_vector() const
  {
    Vector x(size());
    for(int i = 0; i < size(); ++i)
      x[i] = static_cast<FT>(1. + (i % 7) / 7.);
    return x;
  }

  // Solves one system to find out whether solutions need refinement. If they do, keeps the matrix.
  bool is_accurate(const Columns& a)
  {
    Vector b(size(), FT(0)), x = test_vector();
    add_product(a, FT(1), x, b);
    x = b;
    if(!solve_with_factors(x))
      return false;
    if(residual(a, b, x) <= Tolerances::good_residual)
      return true;
    m_matrix = std::make_unique<const Columns>(a);
    return refine(b, x);
  }

  bool solve_with_factors(Vector& x) const
  {
    return m_factors.solve(Block(x.data(), static_cast<Eigen::Index>(x.size()), 1));
  }

  bool solve_scaled(Block b) const
  {
    if(m_matrix == nullptr)
      return m_factors.solve(b);
    const Vector right_sides(b.data(), b.data() + b.size());
    if(!m_factors.solve(b))
      return false;
    for(Eigen::Index k = 0; k < b.cols(); ++k) {
      FT* const begin = b.data() + k * size();
      const auto right_side = right_sides.begin() + k * size();
      Vector x(begin, begin + size());
      if(!refine(Vector(right_side, right_side + size()), x))
        return false;
      std::copy(x.begin(), x.end(), begin);
    }
    return true;
  }

  // Adds the product of the matrix and `factor * x` to `sum`.
  static void add_product(const Columns& a, FT factor, const Vector& x, Vector& sum)
  {
    for(int j = 0; j < a.cols(); ++j)
      for(int k = a.outerIndexPtr()[j]; k < a.outerIndexPtr()[j + 1]; ++k)
        sum[a.innerIndexPtr()[k]] += a.valuePtr()[k] * (factor * x[j]);
  }

  // The backward error of the solution in the maximum norm; infinity instead of NaN. For badly scaled matrices, the
  // product of norms exceeds the range of float.
  static double residual(const Columns& a, const Vector& b, const Vector& x)
  {
    Vector defect(b.size(), FT(0)), row_sums(b.size(), FT(0));
    add_product(a, FT(1), x, defect);
    for(std::size_t i = 0; i < b.size(); ++i)
      defect[i] -= b[i];
    for(Eigen::Index k = 0; k < a.nonZeros(); ++k)
      row_sums[a.innerIndexPtr()[k]] += std::abs(a.valuePtr()[k]);
    const double error = largest(defect), scale = largest(row_sums) * largest(x) + largest(b);
    if(!std::isfinite(error) || !std::isfinite(scale))
      return infinity;
    return scale > 0 ? error / scale : 0.;
  }

  bool refine(const Vector& b, Vector& x) const
  {
    double error = residual(*m_matrix, b, x);
    for(int step = 0; step < refinement_steps && error > Tolerances::good_residual && std::isfinite(error);
        ++step) {
      Vector candidate = b;
      add_product(*m_matrix, FT(-1), x, candidate);
      if(!solve_with_factors(candidate))
        return false;
      for(std::size_t i = 0; i < x.size(); ++i)
        candidate[i] += x[i];
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
