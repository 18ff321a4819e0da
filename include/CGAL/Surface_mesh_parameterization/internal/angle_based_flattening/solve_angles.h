// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SOLVE_ANGLES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SOLVE_ANGLES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/newton_step.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Where the solver stands: angles, multipliers, and what they are worth.
struct Angle_iterate
{
  std::vector<double> alpha;
  Constraint_vector multipliers;
  Constraint_vector residual;
  double energy = 0;

  void evaluate(const Chart& chart, const Angle_energy& angle_energy, const std::vector<double>& beta)
  {
    residual = constraint_residuals(chart, alpha);
    energy = angle_energy.value(alpha, beta);
  }

  double violation() const { return residual.cwiseAbs().sum(); }
  double largest_residual() const { return residual.size() > 0 ? residual.cwiseAbs().maxCoeff() : 0; }

  // The exact penalty function that steps must lower.
  double merit(double penalty) const { return energy + penalty * violation(); }
};

// The longest step, at most the full one, that takes no angle further than a fraction 0.9 of its way to zero. As
// triangles keep their sum, no angle comes near pi then either.
inline double longest_step(const std::vector<double>& alpha, const std::vector<double>& direction)
{
  double length = 1;
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

// Goes along the step, less and less far until the merit function decreases in proportion. Returns the part of the
// step that was taken, or 0 if none would do.
inline double take_step(const Chart& chart, const Angle_energy& energy, const std::vector<double>& beta,
                        const Newton_step& step, double penalty, Angle_iterate& iterate)
{
  const double merit = iterate.merit(penalty), rounding = 1e-12 * merit;
  double slope = -penalty * iterate.violation();
  for(std::size_t c = 0; c < beta.size(); ++c)
    slope += energy.first_derivative(iterate.alpha[c], beta[c]) * step.angles[c];

  Angle_iterate next;
  next.alpha.resize(beta.size());
  for(double length = longest_step(iterate.alpha, step.angles); length > 1e-8; length /= 2) {
    for(std::size_t c = 0; c < beta.size(); ++c)
      next.alpha[c] = iterate.alpha[c] + length * step.angles[c];
    next.evaluate(chart, energy, beta);
    if(next.merit(penalty) <= merit + 1e-4 * length * slope + rounding) {
      next.multipliers = iterate.multipliers + length * step.multipliers;
      iterate = std::move(next);
      return length;
    }
  }
  return 0;
}

// The stopping rule: all constraints are met, and the last step had little left to gain. Both do not depend on the
// resolution of the chart.
inline bool has_converged(const ABF_plus_plus_options& options, const ABF_plus_plus_step& last,
                          std::size_t corners)
{
  const double rounding = 1e-15 * corners;
  return last.constraint_residual <= options.tolerance &&
         last.predicted_decrease <= options.energy_tolerance * last.energy + rounding;
}

// Minimizes the energy subject to the constraints (the loop of Algorithm 18 of the paper), starting from and
// changing `alpha`. The outcome is in `report`: `converged`, `iterations`, `energy`, `constraint_residual`, `steps`.
// Returns `false` if the linear solver fails.
template <typename SolverTraits>
bool solve_angles(const Chart& chart, const std::vector<double>& beta, const ABF_plus_plus_options& options,
                  const SolverTraits& traits, std::vector<double>& alpha, ABF_plus_plus_report& report)
{
  const Angle_energy energy{options.barrier};
  Newton_system<SolverTraits> system(chart, beta, energy, options.step == ABF_plus_plus_options::NEWTON,
                                     traits);
  Newton_step step;
  Angle_iterate iterate;
  iterate.alpha.swap(alpha);
  iterate.multipliers = Constraint_vector::Zero(2 * chart.number_of_interior_vertices);
  iterate.evaluate(chart, energy, beta);

  bool solved = true;
  double penalty = 0;
  while(!report.converged && report.iterations < options.max_iterations) {
    solved = system.compute(iterate.alpha, iterate.multipliers, iterate.residual, step);
    if(!solved)
      break;
    penalty = (std::max)(penalty, sufficient_penalty(iterate, step));
    const double length = take_step(chart, energy, beta, step, penalty, iterate);
    if(length == 0)
      break;
    report.steps.push_back(
        {++report.iterations, iterate.energy, iterate.largest_residual(), step.predicted_decrease, length});
    if(options.on_step)
      options.on_step(report.steps.back());
    report.converged = has_converged(options, report.steps.back(), beta.size());
  }
  report.energy = iterate.energy;
  report.constraint_residual = iterate.largest_residual();
  alpha.swap(iterate.alpha);
  return solved;
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SOLVE_ANGLES_H
