// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_RUN_REPORT_H
#define ABF_BENCHMARK_RUN_REPORT_H

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <functional>
#include <string>
#include <utility>

// The methods that ABF++ is compared with. Every one is a class with a function
//   bool flatten(const Chart& chart, std::vector<Point_2>& uv, Run_report& report) const
// that fills `uv` with as many points as `chart` has vertices, scaled to the area of the surface, and returns `false`,
// with a reason, if it could not do what it promises. Flipped triangles are no failure of methods that do not
// exclude them. The chart must be one that `diagnose()` finds flawless.
namespace ABF_benchmark {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;
typedef abf::Chart Chart;
typedef Chart::Point_2 Point_2;

struct Run_report
{
  int iterations = 0; // of the outermost loop
  double energy = 0;  // what the method minimizes, at the end
  double residual =
      0; // largest violated constraint of the angles, or what another method stops by; 0 if neither
  std::string failure; // a sentence; empty on success

  // Called, if there is one, once the surface is in the form in which the method takes it: where its time begins.
  std::function<void()> begin;
};

inline bool fail(Run_report& report, std::string sentence)
{
  report.failure = std::move(sentence);
  return false;
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_RUN_REPORT_H
