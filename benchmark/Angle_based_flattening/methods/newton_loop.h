// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_NEWTON_LOOP_H
#define ABF_BENCHMARK_NEWTON_LOOP_H

#include "Lagrangian.h"

#include <string>

namespace ABF_benchmark {

// The part of a step that takes no angle further than nine tenths of its way to 0 or pi. The papers take the full
// step, and leave open what happens to angles that it turns over.
inline double length_within_range(const Vector& x, const Vector& step, int number_of_angles)
{
  double length = 1;
  for(int c = 0; c < number_of_angles; ++c) {
    const double room = 0.9 * (step[c] < 0 ? x[c] : abf::pi - x[c]);
    if(length * std::abs(step[c]) > room)
      length = room / std::abs(step[c]);
  }
  return length;
}

// Algorithm 5: Newton's method on F from the optimal angles until ||grad F|| <= `tolerance`. `compute_step` is called
// with x and grad F, and fills a step; it returns `false` if it cannot.
template <typename Compute_step>
bool newton_loop(const Lagrangian& lagrangian, double tolerance, int max_iterations,
                 const Compute_step& compute_step, std::vector<double>& alpha, Run_report& report)
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
  lagrangian.describe(x, report);
  if(!(gradient.norm() <= tolerance))
    return fail(report, "no convergence in " + std::to_string(max_iterations) +
                            " steps: the gradient's norm is " + std::to_string(gradient.norm()));
  return true;
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_NEWTON_LOOP_H
