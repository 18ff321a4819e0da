// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_PAPER_ABF_PLUS_PLUS_H
#define ABF_BENCHMARK_PAPER_ABF_PLUS_PLUS_H

#include "Matrix_split.h"
#include "finish.h"
#include "newton_loop.h"

#include <vector>

namespace ABF_benchmark {

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
    Matrix_split split(lagrangian);
    return newton_loop(
        lagrangian, tolerance, max_iterations,
        [&](const Vector& x, const Vector& gradient, Vector& step) { return split(x, gradient, step); },
        alpha, report);
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

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_PAPER_ABF_PLUS_PLUS_H
