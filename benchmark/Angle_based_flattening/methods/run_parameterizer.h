// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_RUN_PARAMETERIZER_H
#define ABF_BENCHMARK_RUN_PARAMETERIZER_H

#include "methods.h"

#include "../measure/Gauge.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_report.h>

#include <type_traits>

namespace ABF_benchmark {

inline void add_seconds(const SMP::Flattening_report::Seconds& seconds, Measurement& m)
{
  m.add("read", seconds.read);
  m.add("targets", seconds.targets);
  m.add("angles", seconds.angles);
  m.add("layout", seconds.layout);
  m.add("coarsen", seconds.coarsen);
  m.add("solve", seconds.coarse_chart);
  m.add("refine", seconds.refine);
  m.add("polish", seconds.polish);
  m.add("certify", seconds.certify);
  m.add("write", seconds.write);
}

inline void add_report(const SMP::ABF_plus_plus_report& report, Measurement& m)
{
  add_seconds(report.seconds, m);
  int cg_steps = 0, factorizations = 0;
  for(const SMP::ABF_plus_plus_step& step : report.steps) {
    cg_steps += step.linear_iterations;
    factorizations += step.factorizations;
  }
  m.add("newton_steps", report.iterations);
  m.add("cg_steps", cg_steps);
  m.add("factorizations", factorizations);
}

inline void add_report(const SMP::Hierarchical_report& report, Measurement& m)
{
  add_seconds(report.seconds, m);
  m.add("levels", report.levels);
  m.add("coarse_triangles", report.coarse_triangles);
  m.add("retries", report.retries);
  m.add("kernel_insertions", report.kernel_insertions);
  m.add("polished", report.polished);
  m.add("newton_steps", report.polish_iterations);
}

// Those of CGAL have no report.
template <class Parameterizer>
auto add_report_of(const Parameterizer& parameterizer, Measurement& m, int)
    -> decltype(add_report(parameterizer.report(), m))
{
  add_report(parameterizer.report(), m);
}

template <class Parameterizer>
void add_report_of(const Parameterizer&, Measurement&, long)
{}

template <class Parameterizer>
Parameterizer make_parameterizer(const SMP::Hierarchical_options& options)
{
  if constexpr(std::is_constructible_v<Parameterizer, const SMP::Hierarchical_options&>)
    return Parameterizer(options);
  else
    return Parameterizer();
}

template <class Parameterizer>
void run_parameterizer(Surface& surface, const SMP::Hierarchical_options& options, Measurement& m)
{
  const auto parameterized =
      surface.mesh.add_property_map<Mesh::Vertex_index, bool>("v:parameterized", false).first;
  Parameterizer parameterizer = make_parameterizer<Parameterizer>(options);
  const Gauge gauge;
  const SMP::Error_code code = parameterizer.parameterize(
      surface.mesh, surface.border, surface.uv, get(boost::vertex_index, surface.mesh), parameterized);
  gauge.add_to(m);
  if(code != SMP::OK)
    return m.fail(SMP::get_error_message(code));
  add_report_of(parameterizer, m, 0);
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_RUN_PARAMETERIZER_H
