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
#include <CGAL/Solver_interface/internal/SuperLU_arrays.h>
#include <CGAL/Solver_interface/internal/SuperLU_library.h>
#include <CGAL/Solver_interface/internal/SuperLU_matrix.h>
#include <CGAL/SuperLU_options.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <optional>
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

  typedef SuperLU_spare_memory<FT> Spare_memory;

  // In symmetric mode, takes its arrays from `memory` if there is one, and leaves them there.
  explicit SuperLU_factors(std::shared_ptr<const SuperLU_analysis> analysis,
                           std::shared_ptr<Spare_memory> memory = nullptr)
      : m_analysis(analysis), m_is_memory_kept(memory != nullptr && analysis->is_symmetric()),
        m_memory(m_is_memory_kept ? std::move(memory) : std::make_shared<Spare_memory>()),
        m_lower_arrays(m_memory->lower), m_upper_arrays(std::in_place, m_memory->upper), m_lower(), m_upper()
  {}

  SuperLU_factors(const SuperLU_factors&) = delete;
  SuperLU_factors& operator=(const SuperLU_factors&) = delete;

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
    // two arrays of reals, two of integers, the work arrays, and a dozen vectors
    const double arrays = 2 * (sizeof(FT) + sizeof(int)) * entries,
                 bytes = arrays + 2 * work_size(panel) + 64. * size();
    Upper_arrays& upper = **m_upper_arrays;
    if(is_symmetric()) {
      m_lower_arrays->reserve(size(), m_analysis->subscripts() + 1, m_analysis->factor_size());
      upper.reserve(size(), m_analysis->factor_size());
    }
    const std::vector<int>& position = m_analysis->permutation();
    m_lower_arrays->row_permutation = position; // pivots on the diagonal
    upper.column_begin.resize(size());
    upper.column_end.resize(size());
    for(int j = 0; j < size(); ++j) {
      upper.column_begin[position[j]] = a.outerIndexPtr()[j];
      upper.column_end[position[j]] = a.outerIndexPtr()[j + 1];
    }
    upper.tree = m_analysis->elimination_tree(); // SuperLU renumbers it temporarily
    const SuperLU_memory memory(bytes - (is_symmetric() ? arrays : 0) + SuperLU_blas_buffer(bytes));
    return call_superlu(a, entries, panel);
  }

  // Whether the matrix is definite, with pivots of this sign. The elimination tree of A + A' and diagonal pivots are
  // correct only if all pivots are on the diagonal and have the same sign. Elimination is then stable.
  bool pivots_have_sign(FT sign) const
  {
    for(int i = 0; i < size(); ++i)
      if(m_lower_arrays->row_permutation[i] != m_analysis->permutation()[i] || !(sign * pivot(i) > 0))
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
    superlu::SuperMatrix lower = matrix(m_lower), upper = matrix(m_upper);
    Functions::estimate_condition(one_norm, &lower, &upper, norm, &result, &statistics, &info);
    superlu::StatFree(&statistics);
    return info == 0 ? result : 0;
  }

  // Frees U if the pivots of a symmetric matrix are on the diagonal: L alone then suffices to solve.
  void keep_lower_factor_only()
  {
    constexpr int many_columns = 20000; // memory matters more then than the time to get it
    m_upper_arrays.reset();
    if(!m_is_memory_kept || size() > many_columns)
      m_memory->upper.clear();
  }

  // Replaces the columns of `b` by the solutions.
  bool solve(Block b) const
  {
    if(m_upper_arrays)
      return solve_with_both_factors(b);
    const std::vector<int>& order = m_analysis->permutation();
    const typename Spare_vectors::Loan vectors(m_memory->vectors);
    vectors->resize((std::max)(vectors->size(), 2 * static_cast<std::size_t>(size())));
    FT* const permuted = vectors->data();
    for(Eigen::Index k = 0; k < b.cols(); ++k) {
      FT* const column = b.data() + k * size();
      for(int i = 0; i < size(); ++i)
        permuted[order[i]] = column[i];
      m_lower_arrays->solve(size(), permuted, permuted + size());
      for(int i = 0; i < size(); ++i)
        column[i] = permuted[order[i]];
    }
    return true;
  }

  // The supernodes of L
  int number_of_supernodes() const { return m_lower_arrays->number_of_supernodes(size()); }
  Supernode<FT> supernode(int s) const { return m_lower_arrays->supernode(s); }

private:
  typedef SuperLU_lower_arrays<FT> Lower_arrays;
  typedef SuperLU_upper_arrays<FT> Upper_arrays;
  typedef Spare_objects<std::vector<FT>> Spare_vectors;

  FT pivot(int i) const { return m_lower_arrays->pivot(m_analysis->permutation()[i]); }

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

  bool call_superlu(const Columns& a, double entries, int width)
  {
    const int n = size();
    Upper_arrays& upper_arrays = **m_upper_arrays;
    // SuperLU uses the number of entries only for a first guess of the size of the factors.
    superlu::NCPformat store;
    store.nnz = static_cast<int>(std::ceil(entries / (std::max)(1, superlu::sp_ienv(6))));
    store.nzval = const_cast<FT*>(a.valuePtr());
    store.rowind = const_cast<int*>(a.innerIndexPtr());
    store.colbeg = upper_arrays.column_begin.data();
    store.colend = upper_arrays.column_end.data();
    superlu::SuperMatrix columns = {superlu::SLU_NCP, Functions::number_type, superlu::SLU_GE, n, n, &store};

    superlu::superlu_options_t options;
    superlu::set_default_options(&options);
    options.ColPerm = superlu::MY_PERMC;
    options.Equil = superlu::NO;
    options.PrintStat = superlu::NO;
    options.SymmetricMode = superlu::YES; // this only means that the tree is not postordered
    options.DiagPivotThresh = is_symmetric() ? 0. : 1.;
    options.Fact = is_symmetric() ? superlu::SamePattern_SameRowPerm // it fills the arrays that it gets
                                  : superlu::DOFACT;

    superlu::GlobalLU_t growing = superlu::GlobalLU_t();
    superlu::SuperMatrix lower = {}, upper = {};
    if(is_symmetric()) {
      m_lower = m_lower_arrays->pass(growing);
      m_upper = upper_arrays.pass(growing);
      lower = matrix(m_lower);
      upper = matrix(m_upper);
    }
    superlu::SuperLUStat_t statistics;
    superlu::StatInit(&statistics);
    int info = 0;
    {
      const SuperLU_one_blas_thread one_thread;
      Functions::factor(&options, &columns, m_analysis->relax(), width, upper_arrays.tree.data(), nullptr, 0,
                        column_permutation(), m_lower_arrays->row_permutation.data(), &lower, &upper,
                        &growing, &statistics, &info);
    }
    m_expansions = statistics.expansions;
    superlu::StatFree(&statistics);
    m_lower_arrays->take(growing, n);
    upper_arrays.take(growing, n);
    if(growing.expanders != nullptr) // memory ran out
      superlu::superlu_free(growing.expanders);
    if(info > n) // that is what SuperLU says if an allocation failed
      throw std::bad_alloc();
    if(!is_symmetric()) { // SuperLU has allocated the stores
      m_lower = *static_cast<superlu::SCformat*>(lower.Store);
      m_upper = *static_cast<superlu::NCformat*>(upper.Store);
      superlu::superlu_free(lower.Store);
      superlu::superlu_free(upper.Store);
    }
    m_nonzeros = static_cast<std::size_t>(m_lower.nnz) + m_upper.nnz - n;
    return info == 0;
  }

  // SuperLU's interface is not const-correct
  superlu::SuperMatrix matrix(const superlu::SCformat& store) const
  {
    return {superlu::SLU_SC,
            Functions::number_type,
            superlu::SLU_TRLU,
            size(),
            size(),
            const_cast<superlu::SCformat*>(&store)};
  }

  superlu::SuperMatrix matrix(const superlu::NCformat& store) const
  {
    return {superlu::SLU_NC,  Functions::number_type,
            superlu::SLU_TRU, size(),
            size(),           const_cast<superlu::NCformat*>(&store)};
  }

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
    superlu::SuperMatrix lower = matrix(m_lower), upper = matrix(m_upper);
    Functions::solve(superlu::NOTRANS, &lower, &upper, column_permutation(),
                     m_lower_arrays->row_permutation.data(), &right_side, &statistics, &info);
    superlu::StatFree(&statistics);
    return info == 0;
  }

  std::shared_ptr<const SuperLU_analysis> m_analysis;
  bool m_is_memory_kept;
  std::shared_ptr<Spare_memory> m_memory;
  typename Spare_objects<Lower_arrays>::Loan m_lower_arrays;
  std::optional<typename Spare_objects<Upper_arrays>::Loan> m_upper_arrays; // if the upper factor is needed
  superlu::SCformat m_lower;                                                // the factors in these arrays
  superlu::NCformat m_upper;
  std::size_t m_nonzeros = 0;
  int m_expansions = 0;
};

} // namespace CGAL_SUPERLU_TYPES
} // namespace internal
} // namespace CGAL

#endif // CGAL_SOLVER_INTERFACE_INTERNAL_SUPERLU_FACTORS_H
