// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_LOGARITHMIC_ABF_H
#define ABF_BENCHMARK_LOGARITHMIC_ABF_H

#include "finish.h"
#include "newton_loop.h"

#include <unsupported/Eigen/IterativeSolvers>

#include <vector>

namespace ABF_benchmark {

// Zayer, Roessl and Seidel (2005): Newton's method on the full system with the reconstruction constraints in
// logarithms, whose matrix is sparser and worse conditioned, by an iterative solver. Here that is MINRES, for
// symmetric indefinite matrices, and the layout is the least squares one.
struct Logarithmic_ABF
{
  double tolerance = 1e-4;
  int max_iterations = 50;
  double linear_tolerance = 1e-6; // of the linear systems, relative
  int max_linear_iterations = 20000;

  bool solve_angles(const Chart& chart, std::vector<double>& alpha, Run_report& report) const
  {
    const Lagrangian lagrangian(chart, LOGARITHMS);
    return newton_loop(
        lagrangian, tolerance, max_iterations,
        [&](const Vector& x, const Vector& gradient, Vector& step) {
          return solve_iteratively(lagrangian, x, gradient, step);
        },
        alpha, report);
  }

  bool flatten(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
  {
    std::vector<double> alpha;
    return solve_angles(chart, alpha, report) &&
           lay_out_by_least_squares(chart, alpha, abf::far_apart_border_vertices(chart), uv, report);
  }

private:
  bool solve_iteratively(const Lagrangian& lagrangian, const Vector& x, const Vector& gradient,
                         Vector& step) const
  {
    Matrix matrix = lagrangian.hessian(x);
    const Vector scale = scales(lagrangian, matrix, lagrangian.jacobian(x));
    matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
    Eigen::MINRES<Matrix, Eigen::Lower | Eigen::Upper, Eigen::IdentityPreconditioner> solver(matrix);
    solver.setTolerance(linear_tolerance);
    solver.setMaxIterations(max_linear_iterations);
    step = scale.cwiseProduct(solver.solve(-scale.cwiseProduct(gradient)));
    return solver.info() == Eigen::Success && step.allFinite();
  }

  // A diagonal preconditioner, to be applied from both sides: of the angles' block D its own, of the others that of
  // J D^-1 J'.
  static Vector scales(const Lagrangian& lagrangian, const Matrix& hessian, const Matrix& jacobian)
  {
    const int n = lagrangian.number_of_angles();
    const Vector curvature = hessian.diagonal().head(n).cwiseAbs().cwiseMax(1e-3);
    Vector result(hessian.rows());
    result.head(n) = curvature;
    result.tail(jacobian.rows()) = jacobian.cwiseProduct(jacobian) * curvature.cwiseInverse();
    return result.cwiseSqrt().cwiseInverse();
  }
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_LOGARITHMIC_ABF_H
