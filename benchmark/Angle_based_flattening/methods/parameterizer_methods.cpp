// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "methods.h"

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/ARAP_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Iterative_authalic_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/LSCM_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>

namespace ABF_benchmark {

namespace {

void add_report(const SMP::ABF_plus_plus_report& report, Measurement& m)
{
  m.add("read", report.seconds.read);
  m.add("targets", report.seconds.targets);
  m.add("angles", report.seconds.angles);
  m.add("layout", report.seconds.layout);
  m.add("certify", report.seconds.certify);
  m.add("write", report.seconds.write);
  int cg_steps = 0, factorizations = 0;
  for(const SMP::ABF_plus_plus_step& step : report.steps) {
    cg_steps += step.linear_iterations;
    factorizations += step.factorizations;
  }
  m.add("newton_steps", report.iterations);
  m.add("cg_steps", cg_steps);
  m.add("factorizations", factorizations);
}

void add_report(const SMP::Hierarchical_report& report, Measurement& m)
{
  m.add("read", report.seconds.read);
  m.add("coarsen", report.seconds.coarsen);
  m.add("solve", report.seconds.coarse_chart);
  m.add("refine", report.seconds.refine);
  m.add("certify", report.seconds.certify);
  m.add("write", report.seconds.write);
  m.add("levels", report.levels);
  m.add("coarse_triangles", report.coarse_triangles);
  m.add("failed_coarse_charts", static_cast<double>(report.failed_coarse_charts.size()));
  m.add("coarse_method", report.start == SMP::Hierarchical_report::COARSE_PARAMETERIZER);
  m.add("kernel_insertions", report.kernel_insertions);
}

template <class Parameterizer>
void run(Surface& surface, Parameterizer& parameterizer, Measurement& m)
{
  const auto parameterized =
      surface.mesh.add_property_map<Mesh::Vertex_index, bool>("v:parameterized", false).first;
  const Gauge gauge;
  const SMP::Error_code code = parameterizer.parameterize(
      surface.mesh, surface.border, surface.uv, get(boost::vertex_index, surface.mesh), parameterized);
  gauge.add_to(m);
  if(code != SMP::OK)
    m.fail(SMP::get_error_message(code));
}

// Those of CGAL have no options, and no report.
template <class Parameterizer>
void of_cgal(Surface& surface, const SMP::Hierarchical_options&, Measurement& m)
{
  Parameterizer parameterizer;
  run(surface, parameterizer, m);
}

template <SMP::Flattening_options::Holes holes>
void direct(Surface& surface, const SMP::Hierarchical_options&, Measurement& m)
{
  SMP::ABF_plus_plus_options options;
  options.holes = holes;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  run(surface, parameterizer, m);
  add_report(parameterizer.report(), m);
}

// Twists a surface about an axis through the middle of its bounding box.
void twist(Mesh& mesh, double angle)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double x = (box.xmin() + box.xmax()) / 2, y = (box.ymin() + box.ymax()) / 2;
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    const auto p = mesh.point(v);
    const double a = angle * (p.z() - box.zmin()) / (box.zmax() - box.zmin());
    mesh.point(v) = {x + (p.x() - x) * std::cos(a) - (p.y() - y) * std::sin(a),
                     y + (p.x() - x) * std::sin(a) + (p.y() - y) * std::cos(a), p.z()};
  }
}

// The second of two calls of one parameterizer, of which the first is not measured: with moved points from the last
// angles, or with the same points from the target angles.
template <bool warm>
void again(Surface& surface, const SMP::Hierarchical_options&, Measurement& m)
{
  SMP::ABF_plus_plus_options options;
  options.warm_start = warm;
  SMP::ABF_plus_plus_parameterizer_3<Mesh> parameterizer(options);
  Measurement first;
  run(surface, parameterizer, first);
  if(warm)
    twist(surface.mesh, 0.01);
  run(surface, parameterizer, m);
  add_report(parameterizer.report(), m);
}

template <class Coarse_parameterizer>
void hierarchical(Surface& surface, const SMP::Hierarchical_options& options, Measurement& m)
{
  SMP::Hierarchical_parameterizer_3<Mesh, Coarse_parameterizer> parameterizer(options);
  run(surface, parameterizer, m);
  add_report(parameterizer.report(), m);
  if(options.injective) {
    m.add("contact", parameterizer.report().contact);
    m.add("least_clearance", parameterizer.report().least_clearance);
    m.add("border_rejections", parameterizer.report().border_rejections);
  }
  if(options.polish) {
    m.add("polish", parameterizer.report().seconds.polish);
    m.add("polished", parameterizer.report().polished);
    m.add("newton_steps", parameterizer.report().polish_iterations);
  }
}

} // namespace

Methods parameterizer_methods()
{
  return {{"abf++", direct<SMP::Flattening_options::SOLVE>},
          {"abf++-again", again<false>},
          {"abf++-warm", again<true>},
          {"abf++-fill", direct<SMP::Flattening_options::FILL>},
          {"habf++", hierarchical<CGAL::Default>},
          {"hlscm", hierarchical<SMP::LSCM_parameterizer_3<Mesh>>},
          {"lscm", of_cgal<SMP::LSCM_parameterizer_3<Mesh>>},
          {"arap", of_cgal<SMP::ARAP_parameterizer_3<Mesh>>},
          {"conformal", of_cgal<SMP::Discrete_conformal_map_parameterizer_3<Mesh>>},
          {"mean-value", of_cgal<SMP::Mean_value_coordinates_parameterizer_3<Mesh>>},
          {"authalic", of_cgal<SMP::Iterative_authalic_parameterizer_3<Mesh>>}};
}

} // namespace ABF_benchmark
