// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORIZATION_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORIZATION_H

#include <CGAL/Solver_interface/internal/SuperLU_factors.h>
#include <CGAL/Solver_interface/internal/SuperLU_scaling.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>

namespace CGAL {
namespace internal {

// A factorization that can be trusted: what is singular is refused, what is not definite is not taken for it, and
// solutions are refined where they need it. Once `factor()` has returned `FACTORED` the object does not change any
// more, and can be shared by copies of a solver and by threads.
class SuperLU_factorization
{
public:
  typedef SuperLU_factors::Block Block;

  explicit SuperLU_factorization(std::shared_ptr<const SuperLU_analysis> analysis)
      : m_factors(std::move(analysis))
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

  // Factors a matrix of the pattern that was analyzed; it is not needed any more afterwards.
  // `sign` is that of the pivots in symmetric mode.
  Result factor(const SuperLU_matrix& a, double sign)
  {
    if(is_symmetric()) {
      if(!m_factors.factor(a))
        return NOT_DEFINITE;
      if(is_singular(a))
        return FAILED;
      if(!pivots_have_sign(sign))
        return NOT_DEFINITE;
      m_factors.keep_lower_factor_only();
      return is_accurate(a) ? FACTORED : NOT_DEFINITE;
    }
    SuperLU_matrix scaled = a;
    m_scaling.equilibrate(scaled);
    const double significant = 64 * std::numeric_limits<double>::epsilon();
    const bool good = m_factors.factor(scaled) &&
                      least_relative_pivot(Eigen::VectorXd::Ones(size())) > significant &&
                      is_accurate(scaled);
    return good ? FACTORED : FAILED;
  }

  // Replaces the columns of `b` by the solutions, returns false if they are not finite or not accurate.
  bool solve(Block b) const
  {
    m_scaling.scale_rows(b);
    if(!solve_scaled(b))
      return false;
    m_scaling.scale_columns(b);
    return b.allFinite();
  }

private:
  static constexpr double good_residual = 1e-10;
  static constexpr double fair_residual = 1e-6;
  static constexpr int refinement_steps = 5;

  // Only then are the elimination tree of A + A' and pivots from the diagonal right. Elimination is stable then.
  bool pivots_have_sign(double sign) const
  {
    for(int i = 0; i < size(); ++i)
      if(!m_factors.is_pivot_diagonal(i) || !(sign * m_factors.pivot(i) > 0))
        return false;
    return true;
  }

  // The least ratio of a pivot to the `scale` of its column in the matrix, or 0 if one is not a number
  double least_relative_pivot(const Eigen::VectorXd& scale) const
  {
    double least = (std::numeric_limits<double>::max)();
    for(int i = 0; i < size(); ++i) {
      const double ratio = std::abs(m_factors.pivot(i)) / scale[i];
      if(!std::isfinite(ratio))
        return 0;
      least = (std::min)(least, ratio);
    }
    return least;
  }

  // Whether a symmetric matrix differs from a singular one by rounding errors only. A singular matrix has a pivot
  // that is nothing but these, and only where one is small the condition number is worth its estimation.
  bool is_singular(const SuperLU_matrix& a) const
  {
    const double suspicious = 1e-8;
    const double norm = (Eigen::RowVectorXd::Ones(a.rows()) * a.cwiseAbs()).maxCoeff();
    return !(least_relative_pivot(a.diagonal().cwiseAbs()) > suspicious) &&
           !(m_factors.reciprocal_condition(norm) > std::numeric_limits<double>::epsilon());
  }

  // Solves one system to see whether solutions need refinement, and keeps the matrix if they do.
  bool is_accurate(const SuperLU_matrix& a)
  {
    Eigen::MatrixXd b(size(), 1);
    for(int i = 0; i < size(); ++i)
      b(i, 0) = 1. + (i % 7) / 7.;
    b = (a * b).eval();
    Eigen::MatrixXd x = b;
    if(!m_factors.solve(Block(x.data(), x.rows(), x.cols())))
      return false;
    if(residual(a, b, x) <= good_residual)
      return true;
    m_matrix = std::make_unique<const SuperLU_matrix>(a);
    return refine(b, x);
  }

  bool solve_scaled(Block b) const
  {
    if(m_matrix == nullptr)
      return m_factors.solve(b);
    const Eigen::MatrixXd right_side = b;
    if(!m_factors.solve(b))
      return false;
    for(Eigen::Index k = 0; k < b.cols(); ++k) {
      Eigen::MatrixXd x = b.col(k);
      if(!refine(right_side.col(k), x))
        return false;
      b.col(k) = x;
    }
    return true;
  }

  // The backward error of the solution with respect to the maximum norm; infinite if it is not a number
  static double residual(const SuperLU_matrix& a, const Eigen::MatrixXd& b, const Eigen::MatrixXd& x)
  {
    const double defect = (a * x - b).cwiseAbs().maxCoeff();
    const Eigen::VectorXd row_sums = a.cwiseAbs() * Eigen::VectorXd::Ones(a.cols());
    const double norm = row_sums.maxCoeff();
    const double scale = norm * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff();
    if(!x.allFinite() || !std::isfinite(defect) || !std::isfinite(scale))
      return std::numeric_limits<double>::infinity();
    return scale > 0 ? defect / scale : 0.;
  }

  bool refine(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const
  {
    double error = residual(*m_matrix, b, x);
    for(int step = 0; step < refinement_steps && error > good_residual && std::isfinite(error); ++step) {
      Eigen::MatrixXd correction = b - *m_matrix * x;
      if(!m_factors.solve(Block(correction.data(), correction.rows(), correction.cols())))
        return false;
      const Eigen::MatrixXd candidate = x + correction;
      const double candidate_error = residual(*m_matrix, b, candidate);
      if(!(candidate_error < error))
        break;
      x = candidate;
      error = candidate_error;
    }
    return error <= fair_residual;
  }

  SuperLU_factors m_factors;
  SuperLU_scaling m_scaling;
  std::unique_ptr<const SuperLU_matrix> m_matrix; // the scaled matrix, if refinement is needed
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORIZATION_H
