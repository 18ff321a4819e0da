// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Relaxed_map.h"
#include "angle_methods.h"
#include "methods.h"
#include "sequential_hierarchy.h"

#include "../measure/subcommands.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>

#include <vector>

namespace ABF_benchmark {

template <class Chart_method>
void run_on_chart(Surface& surface, const SMP::Hierarchical_options&, Measurement& m)
{
  abf::Chart_reader<Mesh> reader(surface.mesh);
  if(const auto defect = reader.read(surface.border))
    return m.fail(defect.message);
  std::vector<Point_2> uv;
  Run_report report;
  const Gauge gauge;
  const bool done = Chart_method().flatten(reader.chart, uv, report);
  gauge.add_to(m);
  if(!done)
    return m.fail(report.failure);
  m.add("iterations", report.iterations);
  abf::write_chart(reader, uv, surface.uv);
}

Methods chart_methods()
{
  return {{"abf", run_on_chart<Original_ABF>},
          {"paper-abf++", run_on_chart<Paper_ABF_plus_plus>},
          {"log-abf", run_on_chart<Logarithmic_ABF>},
          {"linear-abf", run_on_chart<Linear_ABF>},
          {"mips", run_on_chart<MIPS>},
          {"stretch", run_on_chart<Stretch_minimizer>},
          {"sequential", run_sequential_hierarchy}};
}

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
  const auto exact = abf::exact_layout(chart, alpha, *abf::Linear_solvers(Solver())->low_precision());
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
