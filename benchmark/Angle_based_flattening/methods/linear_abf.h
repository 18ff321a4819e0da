// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_LINEAR_ABF_H
#define ABF_BENCHMARK_LINEAR_ABF_H

#include "Matrix_split.h"
#include "finish.h"

#include <vector>

namespace ABF_benchmark {

// Zayer, Levy and Seidel (2007): the smallest relative change of the optimal angles that meets the constraints
// linearized there, their reconstruction in logarithms. That is one step of sequential linearly constrained
// programming. What the linearization misses, and angles that leave (0, pi), are left to the least squares layout.
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
    lagrangian.describe(x, report);
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

#endif // ABF_BENCHMARK_LINEAR_ABF_H
