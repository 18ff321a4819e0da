// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONJUGATE_GRADIENTS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONJUGATE_GRADIENTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/parallel.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The product of a symmetric matrix, stored as a whole, with a vector
inline void multiply(const Eigen::SparseMatrix<double>& symmetric, const Eigen::VectorXd& x,
                     Eigen::VectorXd& product)
{
  product.resize(x.size());
  parallel_for_blocks(static_cast<int>(x.size()), [&](int begin, int end) {
    for(int j = begin; j < end; ++j)
      product[j] = symmetric.col(j).dot(x);
  });
}

struct Iterative_solution
{
  enum Status
  {
    SOLVED,
    NOT_SOLVED, // steps were too few, or the matrix or its preconditioner is not definite
    FAILED      // the preconditioner gave up
  };
  Status status;
  int steps;
};

// Solves A x = b for a positive definite matrix by preconditioned conjugate gradients, starting at zero, until the
// preconditioned norm of the residual, sqrt(r' M r), is `tolerance` times that at the start. (Eigen's own looks at the
// plain norm, in which large multipliers at slivers hide all others.)
template <typename Preconditioner>
Iterative_solution conjugate_gradients(const Eigen::SparseMatrix<double>& a, const Eigen::VectorXd& b,
                                       Preconditioner& preconditioner, double tolerance, int max_steps,
                                       Eigen::VectorXd& x)
{
  x = Eigen::VectorXd::Zero(b.size());
  Eigen::VectorXd residual = b, correction, direction, product;
  double previous = 0, goal = 0;
  for(int step = 0; step <= max_steps; ++step) {
    if(!preconditioner.apply(residual, correction))
      return {Iterative_solution::FAILED, step};
    const double norm = residual.dot(correction);
    if(step == 0)
      goal = tolerance * tolerance * norm;
    if(norm <= goal)
      return {norm >= 0 ? Iterative_solution::SOLVED : Iterative_solution::NOT_SOLVED, step};
    if(step == 0)
      direction = correction;
    else
      direction = correction + norm / previous * direction;
    previous = norm;

    multiply(a, direction, product);
    const double curvature = direction.dot(product);
    if(!(curvature > 0))
      break;
    x += norm / curvature * direction;
    residual -= norm / curvature * product;
  }
  return {Iterative_solution::NOT_SOLVED, max_steps};
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONJUGATE_GRADIENTS_H
