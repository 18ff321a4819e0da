// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_mesh.h"
#include "subcommands.h"

#include "../methods/angle_methods.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>

#include <vector>

namespace ABF_benchmark {

void lay_out(const std::string& file, const double tolerance, Measurement& m)
{
  Mesh mesh;
  read_mesh(file, mesh);
  const Chart chart = read_chart(mesh);
  std::vector<double> alpha;
  Run_report report;
  if(!Paper_ABF_plus_plus{tolerance}.solve_angles(chart, alpha, report))
    return m.fail("the angles were not found: " + report.failure);
  const auto least_squares = abf::Least_squares_layout(chart, alpha).solve(Solver());
  const auto exact =
      abf::exact_layout(chart, alpha, Solver(), abf::Linear_solvers(Solver())->low_precision());
  if(!least_squares || !exact)
    return m.fail("the linear system of a layout was not solved");

  m.add("triangles", chart.number_of_triangles());
  m.add("residual", report.residual);
  const auto add = [&](const std::string& name, const std::vector<Point_2>& uv) {
    m.add(name, largest_closing_error(chart, alpha, uv));
    m.add(name + "_flips", abf::flipped_triangles(chart, uv).size());
  };
  add("greedy", unfold_greedily(chart, alpha));
  add("least_squares", *least_squares);
  add("exact", exact->uv);
}

} // namespace ABF_benchmark
