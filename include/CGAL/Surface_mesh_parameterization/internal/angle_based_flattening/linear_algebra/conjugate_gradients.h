// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Preconditioned conjugate gradients that stop by the preconditioned norm, in which large multipliers at slivers hide
// nothing. They solve Eq. 16 iteratively (`newton_equation.h`), refine low precision, and solve the steps of injective
// maps.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_CONJUGATE_GRADIENTS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_CONJUGATE_GRADIENTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>

#include <Eigen/Core>

#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// When to stop: at this part of the solution, in the energy norm, and at this largest entry of the residual. That is
// given up when the steps are used up.
struct Iterative_accuracy
{
  double relative_error = 0;
  double largest_residual = (std::numeric_limits<double>::infinity)();
};

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

// The vectors of an iterative solution. The next one may use their memory.
struct Iteration_vectors
{
  Eigen::VectorXd residual, correction, direction, product;
};

// Solves A x = b for a positive definite matrix by preconditioned conjugate gradients, until the preconditioned norm of
// the residual, sqrt(r' M r), has become a small part of that of b. (Eigen's own looks at the plain norm, in which
// large multipliers at slivers hide all others.) Starts at `x`, the solution within a subspace, whose residual is
// `vectors.residual` and orthogonal to it.
template <typename Matrix, typename Preconditioner>
Iterative_solution conjugate_gradients(const Matrix& a, const Eigen::VectorXd& b,
                                       Preconditioner& preconditioner, const Iterative_accuracy& accuracy,
                                       int max_steps, Iteration_vectors& vectors, Eigen::VectorXd& x)
{
  auto& [residual, correction, direction, product] = vectors;
  double previous = 0, goal = 0;
  for(int step = 0;; ++step) {
    Deadline::ask();
    if(!preconditioner.solve(residual, correction))
      return {Iterative_solution::FAILED, step};
    const double norm = residual.dot(correction);
    if(step == 0)
      goal = accuracy.relative_error * accuracy.relative_error * (b.dot(x) + norm);
    if(norm < 0 || (step == max_steps && norm > goal))
      return {Iterative_solution::NOT_SOLVED, step};
    if(norm <= goal && (step == max_steps || residual.cwiseAbs().maxCoeff() <= accuracy.largest_residual))
      return {Iterative_solution::SOLVED, step};
    if(step == 0)
      direction = correction;
    else
      direction = correction + norm / previous * direction;
    previous = norm;

    a.multiply(direction, product);
    const double curvature = direction.dot(product);
    if(!(curvature > 0))
      return {Iterative_solution::NOT_SOLVED, step};
    x += norm / curvature * direction;
    residual -= norm / curvature * product;
  }
}

// Starts at zero.
template <typename Matrix, typename Preconditioner>
Iterative_solution conjugate_gradients(const Matrix& a, const Eigen::VectorXd& b,
                                       Preconditioner& preconditioner, const Iterative_accuracy& accuracy,
                                       int max_steps, Eigen::VectorXd& x)
{
  x = Eigen::VectorXd::Zero(b.size());
  Iteration_vectors vectors;
  vectors.residual = b;
  return conjugate_gradients(a, b, preconditioner, accuracy, max_steps, vectors, x);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_CONJUGATE_GRADIENTS_H
