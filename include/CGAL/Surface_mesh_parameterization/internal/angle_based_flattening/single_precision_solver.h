// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SINGLE_PRECISION_SOLVER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SINGLE_PRECISION_SOLVER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Eigen_matrix.h>
#include <CGAL/Solver_interface/internal/Supernodal_solution.h>
#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/supernodal_factors.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/symmetric_system.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <limits>
#include <memory>
#include <new>
#include <type_traits>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Solves definite systems in single precision: with Eigen's Cholesky factors, which take half the operations and a fraction
// of the memory of SuperLU's L and U, as long as these are not so large that SuperLU's blocks make up for that. Copies
// share the factors and the ordering; all matrices that an object and its copies factor have one pattern.
class Single_precision_solver
{
  typedef Eigen::SparseMatrix<float> Columns;
  typedef Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> Permutation;

  // In the number of unknowns. (Eigen counts the entries of a factor with an `int`, and would not notice if that were too
  // small; there are about 50 for an unknown here.)
  static constexpr int largest_without_blocks = 1000000;

public:
  typedef float NT;
  typedef Eigen_sparse_matrix<float> Matrix;
  typedef Eigen_vector<float> Vector;

  // Uses up the matrix. Returns `false` if it is not definite, or not in single precision, or the factors are too large.
  bool factor(Matrix&& a, NT& denominator)
  {
    denominator = 1;
    m_factors.reset();
    if(a.row_dimension() > largest_without_blocks)
      return m_blocks.factor(a, denominator);
    try {
      return factor(a);
    } catch(const std::bad_alloc&) {
      return false;
    }
  }

  bool linear_solver(const Vector& b, Vector& x) const
  {
    if(m_factors == nullptr)
      return m_blocks.linear_solver(b, x);
    Eigen::VectorXf permuted = *m_permutation * b.eigen_object();
    CGAL::internal::Supernodal_solution<float, Supernodal_factors>(*m_factors).solve(permuted);
    x.eigen_object() = m_permutation->transpose() * permuted;
    return x.eigen_object().allFinite();
  }

private:
  bool factor(Matrix& a)
  {
    order(a.eigen_object());
    Columns permuted(a.row_dimension(), a.row_dimension());
    permuted.selfadjointView<Eigen::Lower>() =
        a.eigen_object().selfadjointView<Eigen::Lower>().twistedBy(*m_permutation);
    Columns().swap(a.eigen_object());
    const Eigen::SimplicialLDLT<Columns, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt(permuted);
    const Eigen::VectorXf pivots = ldlt.vectorD(), diagonal = permuted.diagonal();
    if(ldlt.info() != Eigen::Success || !are_positive(pivots, diagonal))
      return false;
    m_factors = std::make_shared<const Supernodal_factors>(ldlt.matrixL().nestedExpression(), pivots);
    return true;
  }

  void order(const Columns& a)
  {
    if(m_permutation != nullptr && m_permutation->size() == a.rows())
      return;
    Permutation inverse;
    Eigen::AMDOrdering<int>()(a.selfadjointView<Eigen::Lower>(), inverse);
    m_permutation = std::make_shared<const Permutation>(inverse.inverse());
  }

  // A pivot that is nothing but rounding errors does not tell the sign.
  static bool are_positive(const Eigen::VectorXf& pivots, const Eigen::VectorXf& diagonal)
  {
    const float significant = 16 * std::numeric_limits<float>::epsilon();
    return (pivots.array() > significant * diagonal.array()).all();
  }

#ifdef CGAL_SUPERLU_HAS_SINGLE_PRECISION
  SuperLU_solver_traits<float> m_blocks;
#else
  struct Without_blocks
  {
    bool factor(const Matrix&, NT&) { return false; }
    bool linear_solver(const Vector&, Vector&) const { return false; }
  };
  Without_blocks m_blocks;
#endif
  std::shared_ptr<const Permutation> m_permutation;
  std::shared_ptr<const Supernodal_factors> m_factors;
};

template <>
struct Owns_factorization<Single_precision_solver> : std::true_type
{};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SINGLE_PRECISION_SOLVER_H
