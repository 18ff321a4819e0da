// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef UNFOLDING_CLOSING_ERRORS_H
#define UNFOLDING_CLOSING_ERRORS_H

#include "../methods/finish.h"
#include "../methods/greedy_unfolding.h"
#include "../methods/paper_abf_plus_plus.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>

#include <array>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace unfolding {

using namespace ABF_benchmark;

// What one layout makes of angles.
struct Layout_errors
{
  double closing_error = 0; // the largest of all triangles
  std::size_t flips = 0;
};

enum Layout_kind
{
  GREEDY,
  LEAST_SQUARES,
  EXACT
};

constexpr std::array<const char*, 3> layout_titles = {"greedy unfolding", "least squares", "exact"};

// Three layouts of the same angles.
struct Closing_errors
{
  int triangles = 0;
  double tolerance = 0; // of the angles: ||grad F||
  double residual = 0;  // their largest violated constraint
  std::array<Layout_errors, 3> layouts;
};

inline std::vector<Point_2> lay_out(const Chart& chart, const std::vector<double>& alpha, Layout_kind kind)
{
  if(kind == GREEDY)
    return unfold_greedily(chart, alpha);
  std::optional<std::vector<Point_2>> uv;
  if(kind == LEAST_SQUARES)
    uv = abf::Least_squares_layout(chart, alpha).solve(Solver());
  else if(auto layout =
              abf::exact_layout(chart, alpha, Solver(), abf::Linear_solvers(Solver())->low_precision()))
    uv = layout->uv;
  if(!uv)
    throw std::runtime_error("the linear system of a layout was not solved");
  return *uv;
}

inline Closing_errors measure(const Chart& chart, double tolerance)
{
  Closing_errors errors;
  errors.triangles = chart.number_of_triangles();
  errors.tolerance = tolerance;
  std::vector<double> alpha;
  Run_report report;
  if(!Paper_ABF_plus_plus{tolerance}.solve_angles(chart, alpha, report))
    throw std::runtime_error("the angles were not found: " + report.failure);
  errors.residual = report.residual;
  for(const Layout_kind kind : {GREEDY, LEAST_SQUARES, EXACT}) {
    const std::vector<Point_2> uv = lay_out(chart, alpha, kind);
    errors.layouts[kind] = {largest_closing_error(chart, alpha, uv),
                            abf::flipped_triangles(chart, uv).size()};
  }
  return errors;
}

} // namespace unfolding

#endif // UNFOLDING_CLOSING_ERRORS_H
