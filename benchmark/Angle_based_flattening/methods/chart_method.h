// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_CHART_METHOD_H
#define ABF_BENCHMARK_CHART_METHOD_H

#include <CGAL/SuperLU_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/least_squares_layout.h>

#include <string>
#include <utility>
#include <vector>

// What the methods that are implemented here have in common. Every one is a class with a function
//   bool flatten(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
// that fills `uv` with as many points as `chart` has vertices, scaled to the area of the surface, and returns `false`,
// with a reason, if it could not do what it promises. Flipped triangles are no failure of methods that do not
// exclude them. The chart must be one that `diagnose()` finds flawless.
namespace ABF_benchmark {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;
typedef abf::Chart Chart;
typedef Chart::Point_2 Point_2;
typedef CGAL::SuperLU_solver_traits<double> Solver;

struct Run_report
{
  int iterations = 0;  // iterations of the outermost loop
  double energy = 0;   // the final value of the minimized function
  double residual = 0; // largest violated constraint of the angles, or what another method stops by
  std::string failure; // a sentence; empty on success
};

inline bool fail(Run_report& report, std::string sentence)
{
  report.failure = std::move(sentence);
  return false;
}

// The last step of every method.
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

#endif // ABF_BENCHMARK_CHART_METHOD_H
