// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// The factors of one matrix as SuperLU computes them (Demmel et al. 1999), with all sizes and memory checked before
// each call. `SuperLU_factorization.h` decides with them whether a matrix is singular, and solves.

#ifndef CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORS_H
#define CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORS_H

#include <CGAL/Solver_interface/internal/Spare_objects.h>
#include <CGAL/Solver_interface/internal/SuperLU_analysis.h>
#include <CGAL/Solver_interface/internal/SuperLU_library.h>
#include <CGAL/Solver_interface/internal/SuperLU_lower_factor.h>
#include <CGAL/Solver_interface/internal/SuperLU_matrix.h>
#include <CGAL/SuperLU_options.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace CGAL {
namespace internal {
inline namespace CGAL_SUPERLU_TYPES {

// The triangular factors of one matrix. All calls of SuperLU are here.
//
// SuperLU ends the program if a small allocation fails, prints a message if a large one fails, and does not notice if
// an index overflows. So sizes are computed, and available memory is checked, before each call.
template <class FT>
class SuperLU_factors
{
  typedef SuperLU_functions<FT> Functions;
  typedef SuperLU_matrix<FT> Columns;

public:
  typedef Eigen::Map<Eigen::Matrix<FT, Eigen::Dynamic, Eigen::Dynamic>> Block;

  explicit SuperLU_factors(std::shared_ptr<const SuperLU_analysis> analysis) : m_analysis(std::move(analysis))
  {}

  SuperLU_factors(const SuperLU_factors&) = delete;
  SuperLU_factors& operator=(const SuperLU_factors&) = delete;

  ~SuperLU_factors()
  {
    keep_lower_factor_only();
    if(m_lower.Store != nullptr)
      superlu::Destroy_SuperNode_Matrix(&m_lower);
  }

  static std::shared_ptr<const SuperLU_analysis> analyze(const SuperLU_pattern& a, bool symmetric,
                                                         const SuperLU_options& options)
  {
    const int usual = symmetric ? (a.size < 200000 ? 6 : 10) : superlu::sp_ienv(2);
    return std::make_shared<SuperLU_analysis>(a, symmetric, width(options.relax, usual), superlu::sp_ienv(3));
  }

  bool is_symmetric() const { return m_analysis->is_symmetric(); }
  int size() const { return m_analysis->size(); }

  // The number of entries of L and U, without the unit diagonal of L
  std::size_t nonzeros() const { return m_nonzeros; }

  // How often SuperLU had to grow one of its arrays
  int expansions() const { return m_expansions; }

  // Factors a matrix with the analyzed pattern. The matrix is not needed afterwards. Returns `false` if sizes overflow
  // or the matrix is singular. Throws `std::bad_alloc` if memory runs out.
  bool factor(const Columns& a, const SuperLU_options& options = SuperLU_options())
  {
    const double entries = initial_size(a);
    const double upper_bound = (std::max)(entries, static_cast<double>(m_analysis->factor_size()));
    // Symmetric matrices of meshes have so little fill-in that wide panels do not pay: they leave the cache.
    const int panel = largest_panel(width(options.panel_width, is_symmetric() ? 1 : superlu::sp_ienv(1)));
    if(panel == 0 || upper_bound > 0.99 * (std::numeric_limits<int>::max)())
      return false;
    const std::vector<int>& position = m_analysis->permutation();
    m_row_permutation = position; // pivots on the diagonal
    std::vector<int> begin(size()), end(size()), tree = m_analysis->elimination_tree();
    for(int j = 0; j < size(); ++j) {
      begin[position[j]] = a.outerIndexPtr()[j];
      end[position[j]] = a.outerIndexPtr()[j + 1];
    }
    // two arrays of reals, two of integers, the work arrays, and a dozen vectors
    const double bytes = 2 * (sizeof(FT) + sizeof(int)) * entries + 2 * work_size(panel) + 64. * size();
    const SuperLU_memory memory(bytes + SuperLU_blas_buffer(bytes));
    // SuperLU uses the number of entries only for a first guess of the size of the factors.
    superlu::NCPformat store;
    store.nnz = static_cast<int>(std::ceil(entries / (std::max)(1, superlu::sp_ienv(6))));
    store.nzval = const_cast<FT*>(a.valuePtr());
    store.rowind = const_cast<int*>(a.innerIndexPtr());
    store.colbeg = begin.data();
    store.colend = end.data();
    return call_superlu(store, tree, panel);
  }

  // Whether the matrix is definite, with pivots of this sign. The elimination tree of A + A' and diagonal pivots are
  // correct only if all pivots are on the diagonal and have the same sign. Elimination is then stable.
  bool pivots_have_sign(FT sign) const
  {
    for(int i = 0; i < size(); ++i)
      if(m_row_permutation[i] != m_analysis->permutation()[i] || !(sign * pivot(i) > 0))
        return false;
    return true;
  }

  // The least ratio of a pivot to the `scale` of its column in the matrix, or 0 if a ratio is NaN
  template <class Scale>
  FT least_relative_pivot(const Scale& scale) const
  {
    FT least = (std::numeric_limits<FT>::max)();
    for(int i = 0; i < size(); ++i) {
      const FT ratio = std::abs(pivot(i)) / scale(i);
      if(!std::isfinite(ratio))
        return 0;
      least = (std::min)(least, ratio);
    }
    return least;
  }

  // An estimate of the reciprocal condition number in the 1-norm, for a matrix of 1-norm `norm`; 0 if unknown
  FT reciprocal_condition(FT norm) const
  {
    const SuperLU_memory memory(4. * size() * sizeof(FT));
    char one_norm[] = "1";
    FT result = 0;
    int info = 0;
    superlu::SuperLUStat_t statistics;
    superlu::StatInit(&statistics);
    const SuperLU_one_blas_thread one_thread;
    Functions::estimate_condition(one_norm, &m_lower, &m_upper, norm, &result, &statistics, &info);
    superlu::StatFree(&statistics);
    return info == 0 ? result : 0;
  }

  // Frees U if the pivots of a symmetric matrix are on the diagonal: L alone then suffices to solve.
  void keep_lower_factor_only()
  {
    if(m_upper.Store != nullptr)
      superlu::Destroy_CompCol_Matrix(&m_upper);
    m_upper.Store = nullptr;
  }

  // Replaces the columns of `b` by the solutions.
  bool solve(Block b) const
  {
    if(m_upper.Store != nullptr)
      return solve_with_both_factors(b);
    const std::vector<int>& order = m_analysis->permutation();
    const typename Spare_objects<std::vector<FT>>::Loan vectors(m_vectors);
    vectors->resize(2 * static_cast<std::size_t>(size()));
    FT* const permuted = vectors->data();
    for(Eigen::Index k = 0; k < b.cols(); ++k) {
      FT* const column = b.data() + k * size();
      for(int i = 0; i < size(); ++i)
        permuted[order[i]] = column[i];
      lower().solve(permuted, permuted + size());
      for(int i = 0; i < size(); ++i)
        column[i] = permuted[order[i]];
    }
    return true;
  }

  SuperLU_lower_factor<FT> lower() const { return SuperLU_lower_factor<FT>(m_lower); }

private:
  FT pivot(int i) const { return lower().pivot(m_analysis->permutation()[i]); }

  // SuperLU has counters for panels and relaxed supernodes up to the larger of two of its parameters. Its work arrays
  // hold supernodes as wide as the larger of two others.
  static int width(int asked_for, int usual)
  {
    const int counted = (std::max)(superlu::sp_ienv(1), superlu::sp_ienv(2));
    const int largest = (std::max)(superlu::sp_ienv(3), superlu::sp_ienv(7));
    return (std::min)({asked_for > 0 ? asked_for : usual, counted, largest});
  }

  // The largest number of columns, at most `width`, for which no size overflows in SuperLU; 0 if a size overflows
  // even for one column
  int largest_panel(int width) const
  {
    while(width > 0 && work_size(width) > (std::numeric_limits<int>::max)())
      width /= 2;
    return width;
  }

  // The number of bytes of the larger of SuperLU's work arrays
  double work_size(int width) const
  {
    const double n = size();
    const double block = superlu::sp_ienv(3) + superlu::sp_ienv(4);
    const double integers = (2. * width + 8) * n * sizeof(int);
    const double reals = (width * n + (std::max)(n, block * width)) * sizeof(FT);
    return (std::max)(integers, reals);
  }

  // The number of entries for which SuperLU initially allocates memory; it allocates at least a quarter as many
  // subscripts. If the final number is known, this is all it needs. Otherwise bounds above its default tend to be
  // pessimistic, and it may enlarge its arrays.
  double initial_size(const Columns& a) const
  {
    const double needed = (std::max)(static_cast<double>(m_analysis->factor_size()),
                                     allocation_for_subscripts(m_analysis->subscripts()));
    if(is_symmetric())
      return needed;
    const double usual = (std::max)(1., double(superlu::sp_ienv(6))) * static_cast<double>(a.nonZeros());
    return (std::min)(needed, (std::max)(usual, allocation_for_subscripts(m_analysis->relaxed_subscripts())));
  }

  // SuperLU enlarges the array of subscripts as soon as it is full, even if it needs no more.
  static double allocation_for_subscripts(std::size_t number)
  {
    return 4. * (static_cast<double>(number) + 1);
  }

  // `tree` is renumbered temporarily.
  bool call_superlu(superlu::NCPformat& store, std::vector<int>& tree, int width)
  {
    const int n = size();
    superlu::SuperMatrix columns = {superlu::SLU_NCP, Functions::number_type, superlu::SLU_GE, n, n, &store};
    superlu::superlu_options_t options;
    superlu::set_default_options(&options);
    options.ColPerm = superlu::MY_PERMC;
    options.Equil = superlu::NO;
    options.PrintStat = superlu::NO;
    options.SymmetricMode = superlu::YES; // this only means that the tree is not postordered
    options.DiagPivotThresh = is_symmetric() ? 0. : 1.;

    superlu::GlobalLU_t growing = superlu::GlobalLU_t();
    superlu::SuperLUStat_t statistics;
    superlu::StatInit(&statistics);
    int info = 0;
    {
      const SuperLU_one_blas_thread one_thread;
      Functions::factor(&options, &columns, m_analysis->relax(), width, tree.data(), nullptr, 0,
                        column_permutation(), m_row_permutation.data(), &m_lower, &m_upper, &growing,
                        &statistics, &info);
    }
    m_expansions = statistics.expansions;
    superlu::StatFree(&statistics);
    if(info > n) { // that is what SuperLU says if an allocation failed; there are no factors then
      for(void* array : std::initializer_list<void*>{growing.xsup, growing.supno, growing.lsub, growing.xlsub,
                                                     growing.lusup, growing.xlusup, growing.ucol,
                                                     growing.usub, growing.xusub, growing.expanders})
        if(array != nullptr)
          superlu::superlu_free(array);
      throw std::bad_alloc();
    }
    m_nonzeros = static_cast<std::size_t>(static_cast<superlu::SCformat*>(m_lower.Store)->nnz) +
                 static_cast<superlu::NCformat*>(m_upper.Store)->nnz - n;
    return info == 0;
  }

  // SuperLU's interface is not const-correct, hence `mutable` factors, too.
  int* column_permutation() const { return const_cast<int*>(m_analysis->permutation().data()); }

  bool solve_with_both_factors(Block b) const
  {
    const int n = size();
    const SuperLU_memory memory((static_cast<double>(b.cols()) + 2) * n * sizeof(FT));
    superlu::DNformat store = {n, b.data()};
    superlu::SuperMatrix right_side = {
        superlu::SLU_DN, Functions::number_type, superlu::SLU_GE, n, static_cast<int>(b.cols()), &store};
    superlu::SuperLUStat_t statistics;
    superlu::StatInit(&statistics);
    int info = 0;
    const SuperLU_one_blas_thread one_thread;
    std::vector<int>& rows = const_cast<std::vector<int>&>(m_row_permutation);
    Functions::solve(superlu::NOTRANS, &m_lower, &m_upper, column_permutation(), rows.data(), &right_side,
                     &statistics, &info);
    superlu::StatFree(&statistics);
    return info == 0;
  }

  std::shared_ptr<const SuperLU_analysis> m_analysis;
  std::vector<int> m_row_permutation;
  mutable superlu::SuperMatrix m_lower = {}, m_upper = {};
  mutable Spare_objects<std::vector<FT>> m_vectors; // several threads may solve at once
  std::size_t m_nonzeros = 0;
  int m_expansions = 0;
};

} // namespace CGAL_SUPERLU_TYPES
} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORS_H
