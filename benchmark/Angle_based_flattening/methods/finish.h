// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_FINISH_H
#define ABF_BENCHMARK_FINISH_H

#include "Run_report.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/least_squares_layout.h>
#include <CGAL/SuperLU_solver_traits.h>

#include <utility>
#include <vector>

namespace ABF_benchmark {

typedef CGAL::SuperLU_solver_traits<double> Solver; // of every method of ours

// What every method does last.
inline bool finish(const Chart& chart, std::vector<Point_2>& uv, Run_report& report)
{
  for(const Point_2& p : uv)
    if(!CGAL::is_finite(p.x()) || !CGAL::is_finite(p.y()))
      return fail(report, "a coordinate is not finite");
  abf::scale_to_surface_area(chart, uv);
  return true;
}

inline bool lay_out_by_least_squares(const Chart& chart, const std::vector<double>& alpha,
                                     const std::pair<int, int>& pinned, std::vector<Point_2>& uv,
                                     Run_report& report)
{
  const auto solution = abf::Least_squares_layout(chart, alpha, pinned).solve(Solver());
  if(!solution)
    return fail(report, "the linear system of the layout was not solved");
  uv = *solution;
  return finish(chart, uv, report);
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_FINISH_H
