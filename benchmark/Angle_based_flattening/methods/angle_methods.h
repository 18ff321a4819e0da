// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_ANGLE_METHODS_H
#define ABF_BENCHMARK_ANGLE_METHODS_H

// The methods that ABF++ is compared with and that, like it, solve for angles first

#include "Lagrangian.h"
#include "greedy_unfolding.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>

#include <unsupported/Eigen/IterativeSolvers>

#include <algorithm>
#include <string>
#include <vector>

namespace ABF_benchmark {

// The fraction of a step that takes no angle further than nine tenths of its way to 0 or pi. The papers take the full
// step, and do not say what happens to angles that leave (0, pi).
inline double length_within_range(const Vector& x, const Vector& step, int number_of_angles)
{
  const auto alpha = x.head(number_of_angles).array(), change = step.head(number_of_angles).array();
  return (std::min)(1., (0.9 * (change < 0).select(alpha, abf::pi - alpha) / change.abs()).minCoeff());
}

// Algorithm 5: Newton's method on F from the optimal angles until ||grad F|| <= `tolerance`. `compute_step` is called
// with x and grad F, and fills a step; it returns `false` if it cannot.
template <typename Compute_step>
bool newton_loop(const Lagrangian& lagrangian, double tolerance, int max_iterations,
                 Compute_step compute_step, std::vector<double>& alpha, Run_report& report)
{
  Vector x = lagrangian.start(), step;
  Vector gradient = lagrangian.gradient(x);
  while(gradient.norm() > tolerance && report.iterations < max_iterations) {
    if(!compute_step(x, gradient, step))
      return fail(report,
                  "the linear system of step " + std::to_string(report.iterations + 1) + " was not solved");
    x += length_within_range(x, step, lagrangian.number_of_angles()) * step;
    gradient = lagrangian.gradient(x);
    ++report.iterations;
  }
  alpha = lagrangian.angles(x);
  report.residual = lagrangian.residual(x);
  if(!(gradient.norm() <= tolerance))
    return fail(report, "no convergence in " + std::to_string(max_iterations) +
                            " steps: the gradient's norm is " + std::to_string(gradient.norm()));
  return true;
}

// Solves Eq. 6 by the two matrix splits of Section 3, in the paper's own matrices.
class Matrix_split
{
public:
  explicit Matrix_split(const Lagrangian& lagrangian) : m_lagrangian(lagrangian), m_system(Solver()) {}

  bool operator()(const Vector& x, const Vector& gradient, Vector& step)
  {
    const int n_alpha = m_lagrangian.number_of_angles(), n_f = n_alpha / 3;
    const int n_lambda = m_lagrangian.number_of_constraints(), n_2 = n_lambda - n_f;
    const Vector inverse = m_lagrangian.energy_curvature().cwiseInverse(); // Lambda^-1
    const Matrix j = m_lagrangian.jacobian(x);
    const Matrix j_1 = j.topRows(n_f), j_2 = j.bottomRows(n_2); // Eq. 11
    const Vector b_1 = -gradient.head(n_alpha);
    const Vector b = j * inverse.cwiseProduct(b_1) + gradient.tail(n_lambda); // b* of Eq. 9

    const Matrix j_2_lambda = j_2 * inverse.asDiagonal(); // Eq. 12
    const Matrix star = j_2_lambda * j_1.transpose();
    const Matrix star_star = j_2_lambda * j_2.transpose();
    Vector star_inverse(n_f);
    for(int t = 0; t < n_f; ++t)
      star_inverse[t] = 1 / inverse.segment<3>(3 * t).sum();

    Vector lambda(n_lambda), lambda_2(0);
    if(n_2 > 0) { // Eq. 16, with the sign that makes its matrix positive definite
      const Matrix weighted = star * star_inverse.asDiagonal();
      const Matrix product = weighted * star.transpose();
      const Matrix s = star_star - product;
      if(!m_system.set_matrix(s) || !m_system.solve(b.tail(n_2) - weighted * b.head(n_f), lambda_2))
        return false;
    }
    lambda.head(n_f) = star_inverse.cwiseProduct(b.head(n_f) - star.transpose() * lambda_2); // Eq. 17
    lambda.tail(n_2) = lambda_2;
    step.resize(x.size());
    step.head(n_alpha) = inverse.cwiseProduct(b_1 - j.transpose() * lambda); // Eq. 10
    step.tail(n_lambda) = lambda;
    return true;
  }

private:
  const Lagrangian& m_lagrangian;
  abf::Symmetric_system<Solver> m_system;
};

// Sheffer and de Sturler (2001), as Section 2 of the ABF++ paper describes it: Newton's method on the full system,
// whose sparse matrix SuperLU factors with partial pivoting, then the greedy unfolding.
struct Original_ABF
{
  double tolerance = 1e-6; // needed by the unfolding according to Section 4
  int max_iterations = 50;

  bool solve_angles(const Chart& chart, std::vector<double>& alpha, Run_report& report) const
  {
    const Lagrangian lagrangian(chart, PRODUCTS);
    abf::Symmetric_system<Solver> system{Solver()};
    return newton_loop(
        lagrangian, tolerance, max_iterations,
        [&](const Vector& x, const Vector& gradient, Vector& step) {
          return system.set_matrix(lagrangian.hessian(x)) && system.solve(-gradient, step);
        },
        alpha, report);
  }

  bool flatten(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
  {
    std::vector<double> alpha;
    if(!solve_angles(chart, alpha, report))
      return false;
    uv = unfold_greedily(chart, alpha);
    return finish(chart, uv, report);
  }
};

// Direct ABF++ to the letter of the paper: reconstruction constraints as products, sequential linearly constrained
// programming from the optimal angles until ||grad F|| <= 1, SuperLU on Eq. 16 in every step, least squares layout
// with the ends of one edge pinned.
struct Paper_ABF_plus_plus
{
  double tolerance = 1;
  int max_iterations = 100;

  bool solve_angles(const Chart& chart, std::vector<double>& alpha, Run_report& report) const
  {
    const Lagrangian lagrangian(chart, PRODUCTS);
    return newton_loop(lagrangian, tolerance, max_iterations, Matrix_split(lagrangian), alpha, report);
  }

  bool flatten(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
  {
    std::vector<double> alpha;
    const int edge = chart.borders.front().front();
    return solve_angles(chart, alpha, report) &&
           lay_out_by_least_squares(chart, alpha, {chart.edge_source(edge), chart.edge_target(edge)}, uv,
                                    report);
  }
};

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

// Zayer, Levy and Seidel (2007): the smallest relative change of the optimal angles that meets the constraints
// linearized there, their reconstruction in logarithms. That is one step of sequential linearly constrained
// programming. The least squares layout absorbs the error of the linearization, and angles outside of (0, pi).
struct Linear_ABF
{
  bool solve_angles(const Chart& chart, std::vector<double>& alpha, Run_report& report) const
  {
    const Lagrangian lagrangian(chart, LOGARITHMS);
    Vector x = lagrangian.start(), step;
    if(!Matrix_split(lagrangian)(x, lagrangian.gradient(x), step))
      return fail(report, "the linear system of the angles was not solved");
    x += step;
    report.iterations = 1;
    alpha = lagrangian.angles(x);
    report.residual = lagrangian.residual(x);
    return true;
  }

  bool flatten(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
  {
    std::vector<double> alpha;
    return solve_angles(chart, alpha, report) &&
           lay_out_by_least_squares(chart, alpha, abf::far_apart_border_vertices(chart), uv, report);
  }
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_ANGLE_METHODS_H
