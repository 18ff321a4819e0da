// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ROUND_CHART_H
#define FLATTEN_MESH_ROUND_CHART_H

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/flatten_chart.h"
#include "flatten_mesh/output_floats.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Texture_atlas/internal/polygons/round_to_floats.h>

#include <string>
#include <vector>

namespace flatten_mesh {

// Rounds the coordinates to those that the output holds, and measures them. The flattening fails if they are no map
// then.
inline void round_chart(const Command_line& command, Mesh& mesh, const Chart& chart, Flattening& flattening)
{
  namespace ABF = CGAL::Surface_mesh_parameterization::internal::ABF;
  std::vector<ABF::Chart::Point_2> uv(mesh.number_of_vertices());
  for(const Vertex v : chart.vertices) {
    uv[v.idx()] = {flattening.uv[v].x(), flattening.uv[v].y()};
  }
  std::vector<int> corners;
  std::vector<ABF::Border_edge> border;
  for(const Face f : chart.faces) {
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      corners.push_back(static_cast<int>(mesh.target(h).idx()));
      if(mesh.is_border(mesh.edge(h))) {
        border.push_back({static_cast<int>(mesh.source(h).idx()), corners.back()});
      }
    }
  }
  TA::internal::Float_rounder rounder(corners, grid_of_outputs(command), uv);
  rounder.keep_gaps(border);
  const std::vector<int> bad = rounder.run();
  for(const Vertex v : chart.vertices) {
    flattening.uv[v] = Kernel::Point_2(uv[v.idx()].x(), uv[v.idx()].y());
  }
  const bool was_simple = flattening.measures.border_is_simple;
  measure(mesh, chart, flattening);
  if(bad.empty() && (flattening.measures.border_is_simple || !was_simple)) {
    return;
  }
  flattening.report.status = SMP::Diagnosis::PRECISION_EXCEEDED;
  flattening.report.message = "the output holds coordinates in float, which has too few digits for " +
                              (bad.empty() ? std::string("the border") : count_text(bad.size(), "triangle")) +
                              "; use an OBJ file";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_ROUND_CHART_H
