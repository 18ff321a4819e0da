// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_ORIGINAL_ABF_H
#define ABF_BENCHMARK_ORIGINAL_ABF_H

#include "finish.h"
#include "greedy_unfolding.h"
#include "newton_loop.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/symmetric_system.h>

#include <vector>

namespace ABF_benchmark {

// Sheffer and de Sturler (2001), as Section 2 of the ABF++ paper describes it: Newton's method on the full system,
// whose sparse matrix SuperLU factors with partial pivoting, then the greedy unfolding.
struct Original_ABF
{
  double tolerance = 1e-6; // what the unfolding needs, by Section 4
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

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_ORIGINAL_ABF_H
