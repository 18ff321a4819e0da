// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One interface for all models of CGAL's solver traits, whether or not they can keep factors or analyze patterns. A
// matrix that low precision is not enough for is factored in full precision. Callers get solvers from
// `linear_solvers.h`. SuperLU, which the paper uses, is among the models.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_LINEAR_SOLVER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_LINEAR_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Solver_interface/internal/Spare_objects.h>
#include <CGAL/Solver_traits_factory.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>

#include <Eigen/SparseCore>

#include <boost/type_traits/is_detected.hpp>

#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

template <typename Traits>
using Factor_call = decltype(std::declval<Traits&>().factor(std::declval<typename Traits::Matrix>(),
                                                            std::declval<typename Traits::NT&>()));
template <typename Traits>
using Analyze_pattern_call =
    decltype(std::declval<Traits&>().analyze_pattern(std::declval<const typename Traits::Matrix&>()));
template <typename Traits>
using Const_solution_call = decltype(std::declval<const Traits&>().linear_solver(
    std::declval<const typename Traits::Vector&>(), std::declval<typename Traits::Vector&>()));
template <typename Traits>
using Lacks_memory_call = decltype(std::declval<const Traits&>().lacks_memory());

// Whether the traits model `SparseLinearAlgebraWithFactorTraits_d`.
template <typename Traits>
using Has_factor = boost::is_detected<Factor_call, Traits>;

// Whether they can be told a pattern before the first matrix with it, as `SuperLU_solver_traits` can.
template <typename Traits>
using Has_analyze_pattern = boost::is_detected<Analyze_pattern_call, Traits>;

// Whether solving leaves them as they are. Otherwise one thread after the other solves.
template <typename Traits>
using Has_const_solution = boost::is_detected<Const_solution_call, Traits>;

// Whether they tell that memory ran out, as `SuperLU_solver_traits` do. Others throw, or do not know.
template <typename Traits>
using Has_lacks_memory = boost::is_detected<Lacks_memory_call, Traits>;

// A symmetric linear system, solved for one right-hand side after the other. Each solver has factors of its own.
// Several threads may solve with them at once.
class Linear_solver
{
public:
  virtual ~Linear_solver() = default;

  // Returns `false` if the matrix cannot be factored. Throws `std::bad_alloc` if it is known that memory ran out.
  virtual bool set_matrix(const Block_matrix<1>& matrix) = 0;
  virtual bool set_matrix(const Block_matrix<2>& matrix) = 0;
  virtual bool set_matrix(const Diagonal_part<2>& matrix) = 0;

  // Analyzes the pattern of the blocks if that can be done before there are values; copies know it then.
  virtual void analyze_pattern(const Block_matrix<2>& blocks) = 0;

  // Returns `false` on failure, also if the solution is not finite. Throws as above.
  virtual bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution) = 0;

  // A solver of the same kind, for another matrix
  virtual std::unique_ptr<Linear_solver> copy() const = 0;

  // Factors the same matrix in full precision. Returns `false` if it was already, or if that fails.
  virtual bool repeat(const Block_matrix<1>& matrix) = 0;

  // Whether the factors of the last matrix are in full precision because low precision was not enough
  virtual bool is_repeated() const = 0;

  // Whether solutions have fewer digits than `double`, and conjugate gradients can refine them
  virtual bool is_to_be_refined() const = 0;
};

// The caller's traits with the analysis of the last pattern, and memory for matrices, for the solvers of this and later
// runs. If a matrix has another pattern, factorization analyzes that.
template <typename SolverTraits>
class Analyzed_traits
{
public:
  explicit Analyzed_traits(SolverTraits traits) : m_traits(std::move(traits)) {}

  SolverTraits create() const
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    return Solver_traits_factory<SolverTraits>::create(m_traits);
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

// Solves by any model of `SparseLinearAlgebraTraits_d`: with one factorization if the traits offer that. If they have
// low precision, matrices that they refuse are factored in full precision.
template <typename SolverTraits>
class Symmetric_system : public Linear_solver
{
  typedef typename SolverTraits::NT NT;
  typedef typename SolverTraits::Matrix Matrix;
  typedef typename SolverTraits::Vector Vector;

  static constexpr int many_unknowns = 20000; // memory matters more then than the time to get it

public:
  typedef Analyzed_traits<SolverTraits> Shared_traits;
  typedef std::function<std::unique_ptr<Linear_solver>()> Full_precision;

  // A solver that knows what is known to `shared`, where it puts what it analyzes
  explicit Symmetric_system(std::shared_ptr<Shared_traits> shared, Full_precision full_precision = nullptr)
      : Symmetric_system(shared->create(), shared, std::move(full_precision))
  {}

  Symmetric_system(SolverTraits traits, std::shared_ptr<Shared_traits> shared, Full_precision full_precision)
      : m_traits(std::move(traits)), m_shared(std::move(shared)), m_full_precision(std::move(full_precision))
  {}

  explicit Symmetric_system(SolverTraits traits)
      : Symmetric_system(std::make_shared<Shared_traits>(std::move(traits)))
  {}

  bool set_matrix(const Block_matrix<1>& matrix) override { return factor(matrix) || set_full(matrix); }
  bool set_matrix(const Block_matrix<2>& matrix) override { return factor(matrix) || set_full(matrix); }
  bool set_matrix(const Diagonal_part<2>& matrix) override { return factor(matrix) || set_full(matrix); }
  bool set_matrix(const Eigen::SparseMatrix<NT>& matrix) { return factor(matrix); }

  void analyze_pattern(const Block_matrix<2>& blocks) override
  {
    if constexpr(Has_analyze_pattern<SolverTraits>::value) {
      const typename Spare_matrices::Loan matrix(m_shared->matrices());
      convert([&](Eigen::SparseMatrix<NT>& to) { set_pattern_of_blocks(blocks, to); }, *matrix);
      m_traits.analyze_pattern(**matrix); // if that fails, so does the factorization
      m_shared->set(m_traits);
    } else {
      (void)blocks;
    }
  }

  bool solve(const Eigen::VectorXd& right_hand_side, Eigen::VectorXd& solution) override
  {
    if(m_full)
      return m_full->solve(right_hand_side, solution);
    const int n = static_cast<int>(right_hand_side.size());
    const typename Spare_vectors::Loan vectors(m_vectors);
    if(!*vectors || (*vectors)->size != n)
      *vectors = std::make_unique<Vectors>(n);
    auto& [size, b, x] = **vectors;
    const double scale = right_hand_side_scale(right_hand_side);
    for(int i = 0; i < n; ++i)
      b[i] = static_cast<NT>(right_hand_side[i] / scale);
    NT denominator = m_denominator;
    if(!solve(b, x, denominator))
      return fail();
    set_size(solution, n);
    for(int i = 0; i < n; ++i)
      solution[i] = x[i] / denominator * scale;
    return solution.allFinite();
  }

  std::unique_ptr<Linear_solver> copy() const override
  {
    return std::make_unique<Symmetric_system>(Solver_traits_factory<SolverTraits>::create(m_traits), m_shared,
                                              m_full_precision);
  }

  bool repeat(const Block_matrix<1>& matrix) override { return !m_full && set_full(matrix); }
  bool is_repeated() const override { return m_full != nullptr; }

  bool is_to_be_refined() const override
  {
    return !m_full && Has_factor<SolverTraits>::value &&
           std::numeric_limits<NT>::digits < std::numeric_limits<double>::digits;
  }

private:
  // Right-hand sides of double precision must not vanish in single.
  static double right_hand_side_scale(const Eigen::VectorXd& right_hand_side)
  {
    const double scale = std::is_same<NT, double>::value ? 1 : right_hand_side.cwiseAbs().maxCoeff();
    return scale > 0 ? scale : 1;
  }

  template <typename Source>
  bool set_full(const Source& source)
  {
    if(!m_full_precision)
      return false;
    m_full = m_full_precision();
    return m_full->set_matrix(source);
  }

  template <typename Source>
  bool factor(const Source& source)
  {
    m_full.reset();
    m_matrix.emplace(m_shared->matrices());
    convert([&](Eigen::SparseMatrix<NT>& to) { set_eigen_matrix(source, to); }, **m_matrix);
    bool done = true;
    if constexpr(Has_factor<SolverTraits>::value)
      done = m_traits.factor(std::move(***m_matrix), m_denominator);
    if(!Solver_traits_factory<SolverTraits>::keeps_matrix) {
      if((**m_matrix)->row_dimension() > many_unknowns)
        (**m_matrix).reset();
      m_matrix.reset();
    }
    return done || fail();
  }

  bool solve(const Vector& b, Vector& x, NT& denominator)
  {
    if constexpr(Has_const_solution<SolverTraits>::value) {
      (void)denominator;
      return m_traits.linear_solver(b, x);
    } else {
      const std::lock_guard<std::mutex> lock(m_mutex);
      if constexpr(Has_factor<SolverTraits>::value)
        return m_traits.linear_solver(b, x);
      else
        return m_traits.linear_solver(***m_matrix, b, x, denominator);
    }
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
  Full_precision m_full_precision;       // for matrices that these traits refuse, if there is more precision
  std::unique_ptr<Linear_solver> m_full; // if it has factored the last one
  std::optional<typename Spare_matrices::Loan> m_matrix; // the traits may keep a pointer to it
  Spare_vectors m_vectors;
  std::mutex m_mutex; // of solutions, if these change the traits
  NT m_denominator = NT(1);
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_LINEAR_SOLVER_H
