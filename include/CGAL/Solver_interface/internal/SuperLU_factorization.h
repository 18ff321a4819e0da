// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORIZATION_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORIZATION_H

#include <CGAL/Solver_interface/internal/SuperLU_analysis.h>
#include <CGAL/Solver_interface/internal/SuperLU_blas_threads.h>
#include <CGAL/Solver_interface/internal/SuperLU_headers.h>
#include <CGAL/Solver_interface/internal/SuperLU_scaling.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace internal {

// The factors that SuperLU computed of one matrix. Once `factor()` returned true the object does not
// change any more, and can be shared by copies of a solver and by threads.
//
// SuperLU ends the program when one of its small allocations fails, prints when a large one
// does, and does not notice when an index overflows. So sizes are known, and
// memory is seen to be there, before it is called.
class SuperLU_factorization
{
public:
  typedef Eigen::Map<Eigen::MatrixXd> Block;

  explicit SuperLU_factorization(std::shared_ptr<const SuperLU_analysis> analysis)
      : m_analysis(analysis), m_row_permutation(analysis->size()), m_lower(), m_upper()
  {}

  SuperLU_factorization(const SuperLU_factorization&) = delete;
  SuperLU_factorization& operator=(const SuperLU_factorization&) = delete;

  ~SuperLU_factorization()
  {
    if(m_lower.Store != nullptr)
      superlu::Destroy_SuperNode_Matrix(&m_lower);
    if(m_upper.Store != nullptr)
      superlu::Destroy_CompCol_Matrix(&m_upper);
  }

  static std::shared_ptr<const SuperLU_analysis> analyze(const SuperLU_matrix& a, bool symmetric)
  {
    return std::make_shared<SuperLU_analysis>(a, symmetric, superlu::sp_ienv(2), superlu::sp_ienv(3));
  }

  bool is_symmetric() const { return m_analysis->is_symmetric(); }
  int size() const { return m_analysis->size(); }

  // The number of entries of L and U, the unit diagonal of L not counted
  std::size_t nonzeros() const
  {
    const std::size_t lower = static_cast<const superlu::SCformat*>(m_lower.Store)->nnz;
    const std::size_t upper = static_cast<const superlu::NCformat*>(m_upper.Store)->nnz;
    return lower + upper - size();
  }

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
      if(!run(a))
        return NOT_DEFINITE;
      if(is_singular(a))
        return FAILED;
      return pivots_have_sign(sign) && is_accurate(a) ? FACTORED : NOT_DEFINITE;
    }
    SuperLU_matrix scaled = a;
    m_scaling.equilibrate(scaled);
    const double significant = 64 * std::numeric_limits<double>::epsilon();
    const bool good = run(scaled) && least_relative_pivot(Eigen::VectorXd::Ones(size())) > significant &&
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

  static bool can_allocate(double bytes)
  {
    if(bytes >= static_cast<double>((std::numeric_limits<std::ptrdiff_t>::max)()))
      return false;
    void* volatile memory =
        std::malloc(static_cast<std::size_t>(bytes)); // volatile: do not optimize this away
    std::free(memory);
    return memory != nullptr;
  }

  // The largest number of columns that SuperLU may treat at once without a size overflowing in it, or 0
  int panel_size() const
  {
    int width = superlu::sp_ienv(1);
    while(width > 0 && work_size(width) > (std::numeric_limits<int>::max)())
      width /= 2;
    return width;
  }

  // The number of bytes of the larger one of SuperLU's work arrays
  double work_size(int width) const
  {
    const double n = size();
    const double block = superlu::sp_ienv(3) + superlu::sp_ienv(4);
    const double integers = (2. * width + 8) * n * sizeof(int);
    const double reals = (width * n + (std::max)(n, block * width)) * sizeof(double);
    return (std::max)(integers, reals);
  }

  // The number of entries for which SuperLU shall allocate memory initially. More than it will need, if that
  // is known; growing costs copies. Beyond its default, bounds tend to be pessimistic.
  double initial_size(const SuperLU_matrix& a) const
  {
    const double needed = 1.01 * static_cast<double>(m_analysis->factor_size()) + 1000;
    if(is_symmetric())
      return needed;
    return (std::min)(needed,
                      (std::max)(1., double(superlu::sp_ienv(6))) * static_cast<double>(a.nonZeros()));
  }

  bool run(const SuperLU_matrix& a)
  {
    const double entries = initial_size(a);
    const double upper_bound = (std::max)(entries, static_cast<double>(m_analysis->factor_size()));
    const int width = panel_size();
    if(width == 0 || upper_bound > 0.99 * (std::numeric_limits<int>::max)())
      return false;
    // two arrays of reals, two of integers, the work arrays, a dozen of vectors
    if(!can_allocate(24 * entries + 2 * work_size(width) + 64. * size()))
      return false;

    superlu::SuperLUStat_t statistics;
    superlu::StatInit(&statistics);
    const bool done = call_superlu(a, entries, width, statistics);
    superlu::StatFree(&statistics);
    return done;
  }

  bool call_superlu(const SuperLU_matrix& a, double entries, int width, superlu::SuperLUStat_t& statistics)
  {
    const int n = size();
    std::vector<int> begin(n), end(n);
    for(int j = 0; j < n; ++j) {
      begin[m_analysis->permutation()[j]] = a.outerIndexPtr()[j];
      end[m_analysis->permutation()[j]] = a.outerIndexPtr()[j + 1];
    }
    std::vector<int> tree = m_analysis->elimination_tree(); // SuperLU renumbers it temporarily

    // SuperLU uses the number of entries for a first guess of the size of the factors, and only for that.
    superlu::NCPformat store;
    store.nnz = static_cast<int>(std::ceil(entries / (std::max)(1, superlu::sp_ienv(6))));
    store.nzval = const_cast<double*>(a.valuePtr());
    store.rowind = const_cast<int*>(a.innerIndexPtr());
    store.colbeg = begin.data();
    store.colend = end.data();
    superlu::SuperMatrix columns = {superlu::SLU_NCP, superlu::SLU_D, superlu::SLU_GE, n, n, &store};

    superlu::superlu_options_t options;
    superlu::set_default_options(&options);
    options.ColPerm = superlu::MY_PERMC;
    options.Equil = superlu::NO;
    options.PrintStat = superlu::NO;
    options.SymmetricMode = is_symmetric() ? superlu::YES : superlu::NO;
    options.DiagPivotThresh = is_symmetric() ? 0. : 1.;

    superlu::GlobalLU_t growing = superlu::GlobalLU_t();
    int info = 0;
    const SuperLU_one_blas_thread one_thread;
    superlu::dgstrf(&options, &columns, superlu::sp_ienv(2), width, tree.data(), nullptr, 0,
                    column_permutation(), m_row_permutation.data(), &m_lower, &m_upper, &growing, &statistics,
                    &info);
    if(m_lower.Store == nullptr) // memory was exhausted, and what was there is left to us
      free_growing(growing);
    return info == 0;
  }

  static void free_growing(superlu::GlobalLU_t& growing)
  {
    void* arrays[] = {growing.xsup,   growing.supno, growing.lsub, growing.xlsub, growing.lusup,
                      growing.xlusup, growing.ucol,  growing.usub, growing.xusub, growing.expanders};
    for(void* array : arrays) {
      if(array != nullptr)
        superlu::superlu_free(array);
    }
  }

  // SuperLU's interface is not const-correct
  int* column_permutation() const { return const_cast<int*>(m_analysis->permutation().data()); }

  // The entry of U on the diagonal, which is kept with the supernodes of L
  double pivot(int j) const
  {
    const superlu::SCformat* lower = static_cast<const superlu::SCformat*>(m_lower.Store);
    const int first = lower->sup_to_col[lower->col_to_sup[j]];
    return static_cast<const double*>(lower->nzval)[lower->nzval_colptr[j] + (j - first)];
  }

  // Only then are the elimination tree of A + A' and pivots from the diagonal right. Elimination is stable then.
  bool pivots_have_sign(double sign) const
  {
    for(int i = 0; i < size(); ++i) {
      const int j = m_analysis->permutation()[i];
      if(m_row_permutation[i] != j || !(sign * pivot(j) > 0))
        return false;
    }
    return true;
  }

  // The least ratio of a pivot to the `scale` of its column in the matrix, or 0 if one is not a number
  double least_relative_pivot(const Eigen::VectorXd& scale) const
  {
    double least = (std::numeric_limits<double>::max)();
    for(int i = 0; i < size(); ++i) {
      const double ratio = std::abs(pivot(m_analysis->permutation()[i])) / scale[i];
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
    return !(least_relative_pivot(a.diagonal().cwiseAbs()) > suspicious) &&
           !(reciprocal_condition(a) > std::numeric_limits<double>::epsilon());
  }

  double reciprocal_condition(const SuperLU_matrix& a) const
  {
    if(!can_allocate(4. * size() * sizeof(double)))
      return 0;
    const double norm = (Eigen::RowVectorXd::Ones(a.rows()) * a.cwiseAbs()).maxCoeff();
    char one_norm[] = "1";
    double result = 0;
    int info = 0;
    superlu::SuperLUStat_t statistics;
    superlu::StatInit(&statistics);
    const SuperLU_one_blas_thread one_thread;
    superlu::dgscon(one_norm, const_cast<superlu::SuperMatrix*>(&m_lower),
                    const_cast<superlu::SuperMatrix*>(&m_upper), norm, &result, &statistics, &info);
    superlu::StatFree(&statistics);
    return info == 0 ? result : 0;
  }

  // Solves one system to see whether solutions need refinement, and keeps the matrix if they do.
  bool is_accurate(const SuperLU_matrix& a)
  {
    Eigen::MatrixXd b(size(), 1);
    for(int i = 0; i < size(); ++i)
      b(i, 0) = 1. + (i % 7) / 7.;
    b = (a * b).eval();
    Eigen::MatrixXd x = b;
    if(!substitute(Block(x.data(), x.rows(), x.cols())))
      return false;
    if(residual(a, b, x) <= good_residual)
      return true;
    m_matrix = std::make_unique<const SuperLU_matrix>(a);
    return refine(b, x);
  }

  bool solve_scaled(Block b) const
  {
    if(m_matrix == nullptr)
      return substitute(b);
    const Eigen::MatrixXd right_side = b;
    if(!substitute(b))
      return false;
    for(Eigen::Index k = 0; k < b.cols(); ++k) {
      Eigen::MatrixXd x = b.col(k);
      if(!refine(right_side.col(k), x))
        return false;
      b.col(k) = x;
    }
    return true;
  }

  bool substitute(Block b) const
  {
    const int n = size();
    if(!can_allocate((b.cols() + 2.) * n * sizeof(double)))
      return false;
    superlu::DNformat store = {n, b.data()};
    superlu::SuperMatrix right_side = {
        superlu::SLU_DN, superlu::SLU_D, superlu::SLU_GE, n, static_cast<int>(b.cols()), &store};
    superlu::SuperLUStat_t statistics;
    superlu::StatInit(&statistics);
    int info = 0;
    const SuperLU_one_blas_thread one_thread;
    superlu::dgstrs(superlu::NOTRANS, const_cast<superlu::SuperMatrix*>(&m_lower),
                    const_cast<superlu::SuperMatrix*>(&m_upper), column_permutation(),
                    const_cast<int*>(m_row_permutation.data()), &right_side, &statistics, &info);
    superlu::StatFree(&statistics);
    return info == 0;
  }

  // The backward error of the solution with respect to the maximum norm; infinite if it is not a number
  static double residual(const SuperLU_matrix& a, const Eigen::MatrixXd& b, const Eigen::MatrixXd& x)
  {
    const double defect = (a * x - b).cwiseAbs().maxCoeff();
    const double norm = (a.cwiseAbs() * Eigen::VectorXd::Ones(a.cols())).maxCoeff();
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
      if(!substitute(Block(correction.data(), correction.rows(), correction.cols())))
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

  std::shared_ptr<const SuperLU_analysis> m_analysis;
  std::vector<int> m_row_permutation;
  superlu::SuperMatrix m_lower, m_upper;
  SuperLU_scaling m_scaling;
  std::unique_ptr<const SuperLU_matrix> m_matrix; // the scaled matrix, if refinement is needed
};

} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORIZATION_H
