// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One interface for all models of CGAL's solver traits, whether or not they can keep factors or analyze patterns.
// Callers get it from `linear_solvers.h`. SuperLU, which the paper uses, is among the models.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_SYMMETRIC_SYSTEM_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_SYMMETRIC_SYSTEM_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Solver_interface/internal/Spare_objects.h>
#include <CGAL/Solver_traits_properties.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/small_matrix.h>

#include <Eigen/SparseCore>

#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Whether the traits model `SparseLinearAlgebraWithFactorTraits_d`.
template <typename SolverTraits, typename = void>
struct Has_factor : std::false_type
{};

template <typename SolverTraits>
struct Has_factor<SolverTraits, std::void_t<decltype(std::declval<SolverTraits&>().factor(
                                    std::declval<typename SolverTraits::Matrix>(),
                                    std::declval<typename SolverTraits::NT&>()))>> : std::true_type
{};

// Whether they can be told a pattern before the first matrix with it, as `Eigen::SimplicialLDLT` and
// `SuperLU_solver_traits` can.
template <typename SolverTraits, typename = void>
struct Has_analyze_pattern : std::false_type
{};

template <typename SolverTraits>
struct Has_analyze_pattern<SolverTraits, std::void_t<decltype(std::declval<SolverTraits&>().analyze_pattern(
                                             std::declval<const typename SolverTraits::Matrix&>()))>>
    : std::true_type
{};

// Whether solving leaves them as they are, so that several threads may use one factorization.
template <typename SolverTraits, typename = void>
struct Has_const_solution : std::false_type
{};

template <typename SolverTraits>
struct Has_const_solution<SolverTraits,
                          std::void_t<decltype(std::declval<const SolverTraits&>().linear_solver(
                              std::declval<const typename SolverTraits::Vector&>(),
                              std::declval<typename SolverTraits::Vector&>()))>> : std::true_type
{};

// Whether they tell that memory ran out, as `SuperLU_solver_traits` do. Others throw, or do not know.
template <typename SolverTraits, typename = void>
struct Has_lacks_memory : std::false_type
{};

template <typename SolverTraits>
struct Has_lacks_memory<SolverTraits,
                        std::void_t<decltype(std::declval<const SolverTraits&>().lacks_memory())>>
    : std::true_type
{};

// A symmetric linear system, solved for one right-hand side after the other.
class Linear_solver
{
public:
  virtual ~Linear_solver() = default;

  // Returns `false` if the matrix cannot be factored. Throws `std::bad_alloc` if it is known that memory ran out.
  virtual bool set_matrix(const Block_matrix<1>& matrix) = 0;
  virtual bool set_matrix(const Block_matrix<2>& matrix) = 0;
  virtual bool set_matrix(const Diagonal_parts<2>& matrix) = 0;

  // Analyzes the pattern of the blocks if that can be done before there are values; copies know it then.
  virtual void analyze_pattern(const Block_matrix<2>& blocks) = 0;

  // Returns `false` on failure, also if the solution is not finite. Throws as above.
  virtual bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution) = 0;

  // A solver of the same kind, for another matrix
  virtual std::unique_ptr<Linear_solver> copy() const = 0;
};

// The caller's traits with the analysis of the last pattern, and memory for matrices, for the solvers of this and later
// runs. Where a matrix has another pattern, factorization analyzes that.
template <typename SolverTraits>
class Analyzed_traits
{
public:
  explicit Analyzed_traits(SolverTraits traits) : m_traits(std::move(traits)) {}

  SolverTraits get() const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return m_traits;
  }

  void set(const SolverTraits& traits)
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_traits = traits;
  }

  typedef CGAL::internal::Spare_objects<std::unique_ptr<typename SolverTraits::Matrix>> Spare_matrices;
  Spare_matrices& matrices() { return m_matrices; }

private:
  SolverTraits m_traits;
  mutable std::mutex m_mutex;
  Spare_matrices m_matrices;
};

// Solves by any model of `SparseLinearAlgebraTraits_d`: with one factorization where the traits offer that.
template <typename SolverTraits>
class Symmetric_system : public Linear_solver
{
  typedef typename SolverTraits::NT NT;
  typedef typename SolverTraits::Matrix Matrix;
  typedef typename SolverTraits::Vector Vector;

  static constexpr int many_unknowns = 20000; // memory matters more then than the time to get it

public:
  typedef Analyzed_traits<SolverTraits> Shared_traits;

  // A solver that knows what is known to `shared`, where it puts what it analyzes
  explicit Symmetric_system(std::shared_ptr<Shared_traits> shared)
      : m_traits(shared->get()), m_shared(std::move(shared))
  {}

  Symmetric_system(SolverTraits traits, std::shared_ptr<Shared_traits> shared)
      : m_traits(std::move(traits)), m_shared(std::move(shared))
  {}

  explicit Symmetric_system(SolverTraits traits)
      : Symmetric_system(std::make_shared<Shared_traits>(std::move(traits)))
  {}

  bool set_matrix(const Block_matrix<1>& matrix) override { return factor(matrix); }
  bool set_matrix(const Block_matrix<2>& matrix) override { return factor(matrix); }
  bool set_matrix(const Diagonal_parts<2>& matrix) override { return factor(matrix); }
  bool set_matrix(const Eigen::SparseMatrix<NT>& matrix) { return factor(matrix); }

  void analyze_pattern(const Block_matrix<2>& blocks) override
  {
    if constexpr(Has_analyze_pattern<SolverTraits>::value) {
      const typename Spare_matrices::Loan matrix(m_shared->matrices());
      convert([&](Eigen::SparseMatrix<NT>& to) { set_pattern_of_blocks(blocks, to); }, *matrix);
      m_traits.analyze_pattern(**matrix); // if that fails, so does the factorization
      if constexpr(Has_independent_copies<SolverTraits>::value)
        m_shared->set(m_traits);
    } else {
      (void)blocks;
    }
  }

  bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution) override
  {
    const int n = static_cast<int>(right_hand_side.size());
    const typename Spare_vectors::Loan vectors(m_vectors);
    if(!*vectors || (*vectors)->size != n)
      *vectors = std::make_unique<Vectors>(n);
    auto& [size, b, x] = **vectors;
    const double scale = right_hand_side_scale(right_hand_side);
    for(int i = 0; i < n; ++i)
      b[i] = static_cast<NT>(right_hand_side[i] / scale);
    bool done;
    if constexpr(Has_factor<SolverTraits>::value)
      done = m_traits.linear_solver(b, x);
    else
      done = m_traits.linear_solver(***m_matrix, b, x, m_denominator);
    if(!done)
      return fail();
    set_size(solution, n);
    for(int i = 0; i < n; ++i)
      solution[i] = x[i] / m_denominator * scale;
    return solution.allFinite();
  }

  std::unique_ptr<Linear_solver> copy() const override
  {
    return std::make_unique<Symmetric_system>(m_traits, m_shared);
  }

private:
  // Right-hand sides of double precision must not vanish in single.
  static double right_hand_side_scale(const Eigen::VectorXd& right_hand_side)
  {
    const double scale = std::is_same<NT, double>::value ? 1 : right_hand_side.cwiseAbs().maxCoeff();
    return scale > 0 ? scale : 1;
  }

  template <typename Source>
  bool factor(const Source& source)
  {
    m_matrix.emplace(m_shared->matrices());
    convert([&](Eigen::SparseMatrix<NT>& to) { set_eigen_matrix(source, to); }, **m_matrix);
    bool done = true;
    if constexpr(Has_factor<SolverTraits>::value)
      done = m_traits.factor(std::move(***m_matrix), m_denominator);
    if(Has_independent_copies<SolverTraits>::value) {
      if((**m_matrix)->row_dimension() > many_unknowns)
        (**m_matrix).reset();
      m_matrix.reset();
    }
    return done || fail();
  }

  bool fail() const
  {
    if constexpr(Has_lacks_memory<SolverTraits>::value) {
      if(m_traits.lacks_memory())
        throw std::bad_alloc();
    }
    return false;
  }

  // `fill` sets a matrix of Eigen's to what `result` becomes. If memory runs out, `result` is null.
  template <typename Fill>
  static void convert(const Fill& fill, std::unique_ptr<Matrix>& result)
  {
    if constexpr(std::is_base_of<Eigen_sparse_matrix<NT>, Matrix>::value) {
      std::unique_ptr<Matrix> matrix = std::move(result);
      if(!matrix)
        matrix = std::make_unique<Matrix>(1);
      fill(matrix->eigen_object());
      result = std::move(matrix);
    } else {
      Eigen::SparseMatrix<NT> matrix;
      fill(matrix);
      result = std::make_unique<Matrix>(static_cast<int>(matrix.rows()));
      for(int j = 0; j < matrix.outerSize(); ++j)
        for(typename Eigen::SparseMatrix<NT>::InnerIterator it(matrix, j); it; ++it)
          result->set_coef(it.row(), it.col(), it.value(), true);
    }
  }

  // A right-hand side and a solution, converted for the traits
  struct Vectors
  {
    int size;
    Vector b, x;
    explicit Vectors(int n) : size(n), b(n), x(n) {}
  };

  typedef typename Shared_traits::Spare_matrices Spare_matrices;
  typedef CGAL::internal::Spare_objects<std::unique_ptr<Vectors>> Spare_vectors;

  SolverTraits m_traits;
  std::shared_ptr<Shared_traits> m_shared;
  std::optional<typename Spare_matrices::Loan> m_matrix; // the traits may keep a pointer to it
  Spare_vectors m_vectors;                               // several threads may solve at once
  NT m_denominator = NT(1);
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_SYMMETRIC_SYSTEM_H
