// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_SUPERLU_SOLVER_TRAITS_H
#define CGAL_SUPERLU_SOLVER_TRAITS_H

#include <CGAL/config.h>

#ifndef CGAL_SUPERLU_ENABLED
#error "SuperLU_solver_traits needs SuperLU: link with CGAL::SuperLU_support, or define CGAL_SUPERLU_ENABLED."
#endif

#if !__has_include(<Eigen/Core>)
#error                                                                                                       \
    "SuperLU_solver_traits needs Eigen 3.4 or later: link with CGAL::Eigen3_support, or include its folder."
#endif

#include <CGAL/Eigen_sparse_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/Solver_interface/internal/SuperLU_analysis.h>
#include <CGAL/Solver_interface/internal/SuperLU_factorization.h>
#include <CGAL/Solver_interface/internal/SuperLU_matrix.h>
#include <CGAL/Solver_traits_factory.h>
#include <CGAL/SuperLU_options.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>

namespace CGAL {

#ifndef DOXYGEN_RUNNING
inline namespace CGAL_SUPERLU_TYPES {
#endif

/*!
\ingroup PkgSolverInterfaceLS

The class `SuperLU_solver_traits` solves sparse linear systems by the supernodal LU factorization of
the library <a href="https://portal.nersc.gov/project/sparse/superlu/">SuperLU</a> \cgalCite{cgal:degll-ssppa-99}.
SuperLU version 5.3 (or later, with indices of 32 bits) and a BLAS must be available on the system,
as well as \ref thirdpartyEigen "Eigen", whose matrices, vectors and orderings are used.

A matrix that is symmetric and has a diagonal of one sign is factored without exchanges of rows, in an
approximate minimum degree ordering. If all the pivots have that sign too, then the matrix is
definite and this is numerically stable. Any other matrix is factored in a COLAMD ordering with
partial pivoting, after its rows and columns were scaled.

The ordering depends only on the pattern of the matrix. If the next matrix has its entries at the same places, its
factorization reuses the ordering, also in a copy of this object. `analyze_pattern()` computes the ordering beforehand.

\cgalModels{SparseLinearAlgebraTraits_d,SparseLinearAlgebraWithFactorTraits_d,
NormalEquationSparseLinearAlgebraTraits_d}

With `double`, the class replaces `Eigen_solver_traits` in the algorithms of \cgal: the parameterizers of surface
meshes, `Surface_mesh_deformation`, `Heat_method_3::Surface_mesh_geodesic_distances_3`,
`Polygon_mesh_processing::fair()`, `Poisson_reconstruction_function::compute_implicit_function()` and
`Mean_curvature_flow_skeletonization`.

\tparam FT the number type, `double` or `float`

\cgalHeading{Single Precision}

With `float`, the entries of the factors take half of the memory; their indices take the same memory. Solutions take
about 0.6 of the time, and so do factorizations of some hundred thousand rows. Smaller factorizations gain less.
Solutions have a backward error of about \f$ 10^{-7}\f$: a system with condition number \f$ \kappa\f$ is solved to a
relative error of about \f$ 10^{-7} \kappa\f$. This is enough to precondition an iterative solution in `double`.
`symmetric()` returns whether the preconditioner is definite.

A matrix that was rounded from `double` may be refused although the original matrix is not. The reasons are:
- The matrix is singular up to the errors of `float`. For a definite matrix, this means that its least eigenvalue is
  below \f$ 1.2 \cdot 10^{-7}\f$ after scaling to a diagonal of ones. For any other matrix, it means that its reciprocal
  condition number is below this value after scaling of rows and columns.
- An entry became infinite.
- Entries became so small that they lost digits or vanished, and the others in their rows and columns are not much
  larger.

For preconditioners, `SuperLU_options::PIVOTS` checks less and takes less time.
SuperLU must have been built with single precision, as it is by default.

\cgalHeading{Copies}

A copy shares the factorization, which never changes, at the cost of copying a few pointers. Calling
`factor()` or `clear()` on a copy has no effect on the others. The matrix may be destroyed after `factor()`.

\cgalHeading{Errors}

A function that fails returns `false` and leaves the object usable. After a failure of `factor()`, the object holds no
factorization. These are failures:
- a matrix that is not square, is empty, is singular, or has an entry that is not finite. A matrix that is singular up
  to rounding errors is recognized if it is semidefinite, by an estimate of its condition number; otherwise, with
  `double`, only if a pivot is as small as these errors;
- with `SuperLU_options::PIVOTS`, any matrix that is not definite;
- a right-hand side of another size, or with an entry that is not finite;
- a solution that is not finite, or whose backward error stays above \f$ 10^{-6}\f$ (`float`: \f$ 10^{-4}\f$) in spite
  of iterative refinement;
- factors with more than \f$ 2^{31}\f$ entries, or more than fit into memory (`lacks_memory()`).

SuperLU itself would end the program if memory runs out. The memory that it needs is therefore computed before it is
called. If several threads factor at once, the same memory is not promised to two of them.

\cgalHeading{Thread Safety}

Distinct objects can be used by distinct threads at the same time, even if they are copies of one another.
The matrix passed to one of them must not be accessed at the same time, because `CGAL::Eigen_sparse_matrix`
assembles itself on the first access.

\cgalHeading{Complexity}

For matrices from triangle meshes with \f$ n \f$ vertices, the factors have \cgalBigO{n \log n}
entries, and \cgalBigO{n^{3/2}} operations compute them. Solving is linear in the number of entries of the factors.

\sa `CGAL::Eigen_solver_traits<T>`
\sa `CGAL::Eigen_sparse_matrix<T>`
\sa `CGAL::Eigen_vector<T>`
*/
template <class FT = double>
class SuperLU_solver_traits
{
  static_assert(std::is_same<FT, double>::value || std::is_same<FT, float>::value,
                "SuperLU_solver_traits is available for double and float only");

  typedef internal::SuperLU_matrix<FT> Columns;
  typedef internal::SuperLU_sparse_matrix<FT> Sparse_matrix;
  typedef internal::SuperLU_analysis Analysis;
  typedef internal::SuperLU_factorization<FT> Factorization;

public:
  /// \name Types
  /// @{

  /// the number type
  typedef FT NT;
  /// the type of vectors
  typedef CGAL::Eigen_vector<NT> Vector;
  /// the type of matrices: an `Eigen_sparse_matrix<NT>`, whose dimensions can be integers of any type. If it was
  /// constructed with `is_symmetric` equal to `true`, so that it stores one triangle only, then it stands for the whole
  /// symmetric matrix.
  typedef Sparse_matrix Matrix;
  /// the type of indices
  typedef Eigen::Index Index;
  /// the type of several vectors, which are the columns of a dense matrix
  typedef Eigen::Matrix<NT, Eigen::Dynamic, Eigen::Dynamic> Dense_matrix;
  /// @}

  /// \name Creation
  /// @{

  /// constructs a solver with the default options.
  SuperLU_solver_traits() = default;

  /// constructs a solver with the given options.
  explicit SuperLU_solver_traits(const SuperLU_options& options) : m_options(options) {}
  /// @}

  /// \name Operations
  /// @{

  /// solves the linear system \f$ A \times X = B\f$, sets `D` to 1, and keeps the factorization of `A`.
  /// \return `true` if successful, otherwise `X` is unspecified
  bool linear_solver(const Eigen_sparse_matrix<NT>& A, const Vector& B, Vector& X, NT& D)
  {
    return factor(A, D) && linear_solver(B, X);
  }

  /// computes the ordering for matrices with the pattern of `A` that are definite if `A` might be. `factor()` can
  /// then use it, on this object and on copies made later. The factorization is unchanged.
  /// \return `true` if successful
  bool analyze_pattern(const Eigen_sparse_matrix<NT>& A)
  {
    try {
      Columns memory;
      const Columns& a = whole_matrix(A, memory);
      FT sign = 1;
      if(!internal::superlu_is_well_formed(a))
        return false;
      if(internal::superlu_may_be_definite(a, sign))
        analyze(a, true);
      else
        analyze(with_diagonal(a), false);
      return true;
    } catch(const std::bad_alloc&) {
      return false;
    }
  }

  /// factors `A` for subsequent calls of `linear_solver()`, and sets `D` to 1.
  /// \return `true` if successful
  bool factor(const Eigen_sparse_matrix<NT>& A, NT& D)
  {
    D = 1;
    return factor_anew([&] {
      Columns memory;
      return factor_columns(whole_matrix(A, memory));
    });
  }

  /// solves the linear system \f$ A \times X = B\f$, with \f$ A\f$ being the matrix passed to `factor()`.
  /// \return `true` if successful, otherwise `X` is unspecified
  bool linear_solver(const Vector& B, Vector& X) const { return solve(B.eigen_object(), X.eigen_object()); }

  /// solves the linear system \f$ A \times X = B\f$ for a `B` that is a sparse matrix with one column.
  /// \return `true` if successful, otherwise `X` is unspecified
  bool linear_solver(const Eigen_sparse_matrix<NT>& B, Vector& X) const
  {
    const Columns& b = B.eigen_object();
    return b.cols() == 1 && solve(typename Vector::EigenType(b.col(0)), X.eigen_object());
  }

  /// solves one linear system for each column of `B`.
  /// \return `true` if successful, otherwise `X` is unspecified
  bool linear_solver(const Dense_matrix& B, Dense_matrix& X) const { return solve(B, X); }

  /// factors \f$ A^t \times A\f$ for subsequent calls of `normal_equation_solver()`. `A` may have more rows than
  /// columns, and its columns must be linearly independent. Symmetric mode is used.
  /// \return `true` if successful
  bool normal_equation_factor(const Eigen_sparse_matrix<NT>& A)
  {
    return factor_anew([&] {
      Columns memory;
      const Columns& a = whole_matrix(A, memory);
      m_transposed = std::make_shared<const Columns>(a.transpose());
      return factor_columns(*m_transposed * a);
    });
  }

  /// solves the linear system \f$ A^t \times A \times X = A^t \times B\f$, with \f$ A\f$ being the matrix passed
  /// to `normal_equation_factor()`: finds the `X` for which \f$ A \times X\f$ is nearest to `B`.
  /// \return `true` if successful, otherwise `X` is unspecified
  bool normal_equation_solver(const Vector& B, Vector& X) const
  {
    if(m_transposed == nullptr || B.rows() != m_transposed->cols())
      return false;
    Vector right_side;
    right_side.eigen_object() = *m_transposed * B.eigen_object();
    return linear_solver(right_side, X);
  }

  /// calls `normal_equation_factor(A)` and then `normal_equation_solver(B, X)`.
  bool normal_equation_solver(const Eigen_sparse_matrix<NT>& A, const Vector& B, Vector& X)
  {
    return normal_equation_factor(A) && normal_equation_solver(B, X);
  }

  /// frees the memory of the factorization and of the ordering, unless a copy of this object needs it.
  void clear() { *this = SuperLU_solver_traits(m_options); }

  /// @}

  /// \name Access
  /// @{

  /// returns the options.
  const SuperLU_options& options() const { return m_options; }

  /// returns whether there is a factorization, that is, whether the last call of `factor()` was successful.
  bool is_factored() const { return m_factorization != nullptr; }

  /// returns whether the matrix was found to be definite.
  bool symmetric() const { return is_factored() && m_factorization->is_symmetric(); }

  /// returns the number of entries of both factors, and 0 without a factorization.
  std::size_t factor_nonzeros() const { return is_factored() ? m_factorization->nonzeros() : 0; }

  /// returns whether memory ran out in the last call of `factor()`, or in a call of `linear_solver()` after it, which
  /// then returned `false`.
  bool lacks_memory() const { return m_lacks_memory.value; }

  /// returns whether the last call of `factor()` could use the ordering of an earlier one.
  bool ordering_reused() const { return m_ordering_reused; }

  /// @}

private:
  // Runs `factor`, which returns whether it succeeded; what was factored before is forgotten.
  template <class Factor>
  bool factor_anew(const Factor& factor)
  {
    m_factorization.reset();
    m_transposed.reset();
    m_ordering_reused = false;
    m_lacks_memory.value = false;
    try {
      if(factor())
        return true;
    } catch(const std::bad_alloc&) {
      m_lacks_memory.value = true;
    }
    m_factorization.reset();
    m_transposed.reset();
    return false;
  }

  // The whole matrix that `A` stands for, which is put into `memory` if `A` stores one triangle of it.
  static const Columns& whole_matrix(const Eigen_sparse_matrix<NT>& A, Columns& memory)
  {
    const Columns& a = A.eigen_object();
    if(A.row_dimension() != A.column_dimension() || !internal::superlu_stores_one_triangle(A))
      return a;
    memory = a.template selfadjointView<Eigen::Lower>();
    return memory;
  }

  // SuperLU writes outside of its arrays if the rows and columns cannot be matched along stored entries. On the
  // diagonal they can, also if the entries there are zero.
  static Columns with_diagonal(const Columns& a)
  {
    Columns zero(a.rows(), a.cols());
    zero.setIdentity();
    zero.coeffs().setZero();
    return a + zero;
  }

  bool factor_columns(const Columns& a)
  {
    if(!internal::superlu_is_well_formed(a))
      return false;
    FT sign = 1;
    if(internal::superlu_may_be_definite(a, sign)) {
      const typename Factorization::Result result = factor_columns(a, true, sign);
      if(result != Factorization::NOT_DEFINITE)
        return result == Factorization::FACTORED;
    }
    if(m_options.check == SuperLU_options::PIVOTS)
      return false;
    const int max_entries = 500000000; // COLAMD's workspace and the graph of A'A are indexed by int
    return a.nonZeros() <= max_entries &&
           factor_columns(with_diagonal(a), false, sign) == Factorization::FACTORED;
  }

  typename Factorization::Result factor_columns(const Columns& a, bool symmetric, FT sign)
  {
    m_ordering_reused = analyze(a, symmetric);
    std::shared_ptr<Factorization> factorization =
        std::make_shared<Factorization>(symmetric ? m_symmetric_analysis : m_general_analysis, m_options);
    const typename Factorization::Result result = factorization->factor(a, sign);
    if(result == Factorization::FACTORED)
      m_factorization = factorization;
    return result;
  }

  // Returns whether the pattern was analyzed before.
  bool analyze(const Columns& a, bool symmetric)
  {
    std::shared_ptr<const Analysis>& analysis = symmetric ? m_symmetric_analysis : m_general_analysis;
    if(analysis != nullptr && analysis->has_pattern_of(a))
      return true;
    analysis.reset();
    analysis = internal::SuperLU_factors<FT>::analyze(a, symmetric, m_options);
    return false;
  }

  template <class Vectors>
  bool solve(const Vectors& b, Vectors& x) const
  {
    if(!is_factored() || b.rows() != m_factorization->size() || !b.allFinite())
      return false;
    try {
      x = b;
      const Eigen::Index width = 16; // limits the memory that SuperLU needs
      for(Eigen::Index k = 0; k < x.cols(); k += width) {
        const Eigen::Index end = (std::min)(k + width, static_cast<Eigen::Index>(x.cols()));
        if(!m_factorization->solve(typename Factorization::Block(x.data() + k * x.rows(), x.rows(), end - k)))
          return false;
      }
      return true;
    } catch(const std::bad_alloc&) {
      m_lacks_memory.value = true;
      return false;
    }
  }

  SuperLU_options m_options;
  std::shared_ptr<const Factorization> m_factorization;
  std::shared_ptr<const Analysis> m_symmetric_analysis, m_general_analysis;
  std::shared_ptr<const Columns> m_transposed; // of the matrix of the normal equation
  bool m_ordering_reused = false;

#ifndef DOXYGEN_RUNNING
  // Solving is a constant operation, which several threads may call.
  struct Flag
  {
    Flag() = default;
    Flag(const Flag& other) noexcept : value(other.value.load()) {}
    Flag& operator=(const Flag& other) noexcept
    {
      value = other.value.load();
      return *this;
    }
    mutable std::atomic<bool> value{false};
  };
  Flag m_lacks_memory;
#endif
};

#ifndef DOXYGEN_RUNNING
} // namespace CGAL_SUPERLU_TYPES

template <class FT>
struct Solver_traits_factory<SuperLU_solver_traits<FT>>
{
  static constexpr bool keeps_matrix = false;
  static SuperLU_solver_traits<FT> create(const SuperLU_solver_traits<FT>& traits) { return traits; }
};
#endif

#ifdef CGAL_SUPERLU_HAS_SINGLE_PRECISION
template <>
struct Low_precision_solver_traits<SuperLU_solver_traits<double>>
{
  typedef SuperLU_solver_traits<float> type;

  static type create(const SuperLU_solver_traits<double>& traits)
  {
    SuperLU_options options = traits.options();
    options.check = SuperLU_options::PIVOTS;
    return type(options);
  }
};
#endif

} // namespace CGAL

#endif // CGAL_SUPERLU_SOLVER_TRAITS_H
