// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The main loop of ABF++ (Algorithm 18): step lengths, a merit function, forcing terms and the stopping rule around
// Newton's method. `direct_strategies.h` calls `solve_angles()`, and lays out the angles afterwards.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_SOLVE_ANGLES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_SOLVE_ANGLES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/loop_equations.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/newton_system.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// How far to go along each step. Where the Hessian is lifted to be definite, full steps are too short, all by nearly
// the same factor, and converge only linearly. Two of them tell the factor: this is Anderson acceleration with one
// vector, after a full step.
class Step_lengths
{
  static constexpr double largest_residual = 0.03; // farther away, steps do not tell it yet
  static constexpr double least_excess = 0.4;      // below, the next step is as good without it

public:
  // 1, or more. The constraints are violated by at most `residual`.
  double next(const std::vector<double>& beta, const Newton_step& step, double residual) const
  {
    if(!m_last_was_full || residual > largest_residual)
      return 1;
    const int corners = static_cast<int>(beta.size());
    const auto change = [&](int c) { return (step.angles[c] - m_last_angles[c]) / beta[c]; };
    const double product =
        parallel_sum(corners, [&](int c) { return change(c) * (step.angles[c] / beta[c]); });
    const double square = parallel_sum(corners, [&](int c) { return change(c) * change(c); });
    return -product > least_excess * square ? 1 - product / square : 1;
  }

  // Remembers a step, of which a part was taken, and returns other memory in exchange.
  void remember(Newton_step& step, double length)
  {
    m_last_angles.swap(step.angles);
    m_last_was_full = length == 1;
  }

private:
  std::vector<double> m_last_angles;
  bool m_last_was_full = false;
};

// The state of the solver: angles and multipliers, with their residuals and energy
struct Angle_iterate
{
  std::vector<double> alpha;
  Constraint_vector multipliers;
  Constraint_vector residual;
  double energy = 0;
  double largest_residual = 0;

  // The memory of `log_sines` is used.
  void evaluate(const Chart& chart, const Angle_energy& angle_energy, const std::vector<double>& beta,
                std::vector<double>& log_sines)
  {
    find_constraint_residuals(chart, alpha, log_sines, residual);
    energy = angle_energy.value(alpha, beta, chart.weight);
    // The gap that the layout closes adds to the difference of lengths.
    largest_residual =
        (std::max)(largest_violation(chart, residual), 2 * largest_seam_difference(chart, alpha));
  }

  double violation() const { return residual.cwiseAbs().sum(); }

  // The exact penalty function that steps must lower.
  double merit(double penalty) const { return energy + penalty * violation(); }
};

// The longest step up to `length` that takes no angle further than a fraction 0.9 of its way to zero. As triangles keep
// their sum, no angle comes near pi then either.
inline double longest_step(const std::vector<double>& alpha, const std::vector<double>& direction,
                           double length)
{
  for(std::size_t c = 0; c < alpha.size(); ++c)
    if(-length * direction[c] > 0.9 * alpha[c])
      length = -0.9 * alpha[c] / direction[c];
  return length;
}

// The merit function decreases along a step if each violation weighs more than its multiplier.
inline double sufficient_penalty(const Angle_iterate& iterate, const Newton_step& step)
{
  return step.multipliers.size() > 0 ? 1.5 * (iterate.multipliers + step.multipliers).cwiseAbs().maxCoeff()
                                     : 0;
}

// Goes `length` times the step, or halves this length until the merit function decreases in proportion. Returns the
// part of the step that was taken, or 0 if there is none. The memory of `next` and `log_sines` is used.
inline double take_step(const Chart& chart, const Angle_energy& energy, const std::vector<double>& beta,
                        const Newton_step& step, double length, double penalty, Angle_iterate& iterate,
                        Angle_iterate& next, std::vector<double>& log_sines)
{
  const double merit = iterate.merit(penalty), rounding = 1e-12 * merit;
  const int corners = chart.number_of_corners();
  const double slope = parallel_sum(corners,
                                    [&](int c) {
                                      return chart.weight_of_triangle(c / 3) *
                                             energy.first_derivative(iterate.alpha[c], beta[c]) *
                                             step.angles[c];
                                    }) -
                       penalty * iterate.violation();

  next.alpha.resize(beta.size());
  length = longest_step(iterate.alpha, step.angles, length);
  for(; length > 1e-8; length = length > 1 ? 1 : length / 2) {
    parallel_for_blocks(corners, [&](int begin, int end) {
      for(int c = begin; c < end; ++c)
        next.alpha[c] = iterate.alpha[c] + length * step.angles[c];
    });
    next.evaluate(chart, energy, beta, log_sines);
    if(next.merit(penalty) <= merit + 1e-4 * length * slope + rounding) {
      iterate.multipliers += length * step.multipliers;
      iterate.multipliers.swap(next.multipliers);
      std::swap(iterate, next);
      return length;
    }
  }
  return 0;
}

// How exactly the step from each iterate is solved for. An exact step would reduce the residuals about as much as the
// last one did, squared; to solve for more is wasted. (Eisenstat and Walker 1996, their second choice.) Where it was
// not enough, the next steps are more exact.
class Forcing_terms
{
public:
  explicit Forcing_terms(double tolerance) : m_tolerance(tolerance) {}

  Iterative_accuracy next(double largest_residual)
  {
    const bool is_first = m_last_residual == 0;
    const double change = is_first ? 0 : largest_residual / m_last_residual;
    if(largest_residual > m_tolerance && change > 0.5)
      m_caution /= 10;
    m_last_residual = largest_residual;
    Iterative_accuracy accuracy;
    accuracy.relative_error = m_caution * 1e-2;
    if(!is_first)
      accuracy.largest_residual =
          m_caution * (std::min)(0.1 * largest_residual,
                                 (std::max)(change * change * largest_residual, 0.1 * m_tolerance));
    return accuracy;
  }

  // Asks for more exact steps from now on; returns `false` if more exact steps would have no effect.
  bool tighten()
  {
    m_caution /= 10;
    return m_caution > 1e-10;
  }

private:
  double m_tolerance, m_caution = 1, m_last_residual = 0;
};

// The stopping rule: all constraints are met, and the last step had little left to gain. Both do not depend on the
// resolution of the chart.
inline bool has_converged(const ABF_plus_plus_options& options, const Angle_iterate& iterate,
                          double predicted_decrease)
{
  const double rounding = 1e-15 * static_cast<double>(iterate.alpha.size());
  return iterate.largest_residual <= options.tolerance &&
         predicted_decrease <= options.energy_tolerance * iterate.energy + rounding;
}

// The result of the solver
struct Angle_solution
{
  std::vector<double> alpha;
  Constraint_vector multipliers;
  bool is_solved = true; // otherwise the linear solver failed
  bool converged = false;
  int iterations = 0;
  double energy = 0;
  double constraint_residual = 0;
  std::vector<ABF_plus_plus_step> steps;
  std::unique_ptr<Linear_solver> scalar_solver; // may know the pattern of the layout's system
};

// Minimizes the energy subject to the constraints (the loop of Algorithm 18 of the paper), from angles `start` and from
// `multipliers`, or from zero if there are none.
inline Angle_solution solve_angles(const Chart& chart, const std::vector<double>& beta,
                                   const ABF_plus_plus_options& options, const Linear_solvers& solvers,
                                   std::vector<double> start,
                                   const Constraint_vector& multipliers = Constraint_vector())
{
  constexpr int many_triangles = 500000; // a factor needs most of the memory then
  const Angle_energy energy{options.barrier};
  Newton_system system(chart, beta, energy, options.step == ABF_plus_plus_options::NEWTON, solvers,
                       options.linear_solver == ABF_plus_plus_options::ITERATIVE,
                       chart.number_of_triangles() >= many_triangles);
  Newton_step step;
  Angle_iterate iterate, next; // the memory of `next` is not taken before the first factorization
  std::vector<double> log_sines;
  iterate.alpha = std::move(start);
  iterate.multipliers =
      multipliers.size() > 0 ? multipliers : Constraint_vector::Zero(number_of_constraints(chart));
  iterate.evaluate(chart, energy, beta, log_sines);

  Angle_solution result;
  Forcing_terms forcing_terms(options.tolerance);
  Step_lengths step_lengths;
  double penalty = 0;
  while(!result.converged && result.iterations < options.max_iterations) {
    result.is_solved = system.compute(iterate.alpha, iterate.multipliers, iterate.residual, step,
                                      forcing_terms.next(iterate.largest_residual));
    if(!result.is_solved)
      break;
    penalty = (std::max)(penalty, sufficient_penalty(iterate, step));
    const double length =
        take_step(chart, energy, beta, step, step_lengths.next(beta, step, iterate.largest_residual), penalty,
                  iterate, next, log_sines);
    if(length == 0 && system.equation().steps() > 0 && forcing_terms.tighten())
      continue; // a more exact step may lower the merit function where this one did not
    result.converged = has_converged(options, iterate, step.predicted_decrease);
    if(length == 0) // rounding leaves nothing to gain, or there is no way
      break;
    result.steps.push_back({++result.iterations, iterate.energy, iterate.largest_residual,
                            step.predicted_decrease, length, system.equation().steps(),
                            system.equation().factorizations(), system.equation().repeated_factorizations()});
    visit_step(options.visitor, result.steps.back());
    step_lengths.remember(step, length);
  }
  result.energy = iterate.energy;
  result.constraint_residual = iterate.largest_residual;
  result.alpha = std::move(iterate.alpha);
  result.multipliers = std::move(iterate.multipliers);
  result.scalar_solver = system.equation().scalar_solver();
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_SOLVE_ANGLES_H
