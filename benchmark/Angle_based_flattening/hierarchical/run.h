// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_RUN_H
#define HIERARCHICAL_RUN_H

#include "measure.h"

#include "../common/Peak_memory.h"
#include "../common/read_mesh.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_report.h>

#include <malloc.h>

// What the translation units that measure have in common.
namespace hierarchical {

namespace SMP = CGAL::Surface_mesh_parameterization;
typedef boost::graph_traits<Mesh>::halfedge_descriptor Halfedge;
typedef Mesh::Property_map<Mesh::Vertex_index, CGAL::Epick::Point_2> UV_map;

SMP::Hierarchical_options options_of(const Task& task);

void take_report(const SMP::Hierarchical_report& report, Measurement& measurement);
void take_report(const SMP::ABF_plus_plus_report& report, Measurement& measurement);
void measure_map(const Mesh& mesh, Halfedge border, UV_map uv, Measurement& measurement);

// Run methods whose code takes long to compile, in files of their own: LSCM, hierarchical or not, and the
// sequential hierarchy.
Measurement run_lscm(const Task& task, Mesh& mesh);
Measurement run_sequential(const Task& task, Mesh& mesh);

template <class Parameterizer>
auto take_report_of(const Parameterizer& parameterizer, Measurement& measurement, int)
    -> decltype(take_report(parameterizer.report(), measurement))
{
  take_report(parameterizer.report(), measurement);
}

template <class Parameterizer>
void take_report_of(const Parameterizer&, Measurement&, long)
{}

template <class Parameterizer>
Measurement run(Mesh& mesh, Parameterizer parameterizer)
{
  const Halfedge border = CGAL::Polygon_mesh_processing::longest_border(mesh).first;
  if(border == boost::graph_traits<Mesh>::null_halfedge()) {
    return failed_measurement("the mesh has no border");
  }
  const UV_map uv = mesh.add_property_map<Mesh::Vertex_index, CGAL::Epick::Point_2>("v:uv").first;
  const auto parameterized = mesh.add_property_map<Mesh::Vertex_index, bool>("v:parameterized", false).first;

  Measurement measurement;
  measurement.numbers["vertices"] = static_cast<double>(mesh.number_of_vertices());
  measurement.numbers["triangles"] = static_cast<double>(mesh.number_of_faces());
  malloc_trim(0); // what reading the mesh has freed shall not be used again unseen
  const Peak_memory memory;
  CGAL::Real_timer timer;
  timer.start();
  const SMP::Error_code status =
      parameterizer.parameterize(mesh, border, uv, get(boost::vertex_index, mesh), parameterized);
  timer.stop();
  if(status != SMP::OK) {
    return failed_measurement(SMP::get_error_message(status));
  }
  measurement.numbers["seconds"] = timer.time();
  measurement.numbers["bytes"] = memory.bytes();
  take_report_of(parameterizer, measurement, 0);
  measure_map(mesh, border, uv, measurement);
  return measurement;
}

} // namespace hierarchical

#endif // HIERARCHICAL_RUN_H
