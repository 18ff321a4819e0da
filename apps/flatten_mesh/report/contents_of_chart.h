// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CONTENTS_OF_CHART_H
#define FLATTEN_MESH_CONTENTS_OF_CHART_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/plain/report_text.h"
#include "flatten_mesh/plain/scale_stretch.h"
#include "flatten_mesh/plain/textured_chart.h"
#include "flatten_mesh/pictures/Up_axis.h"
#include "flatten_mesh/report/Report_contents.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The face of the input that a triangle of a chart is: a side of it leads there, because the input is a manifold.
inline Face face_of_input(const Mesh& input, const Mesh& mesh, const Chart& chart, const Face f)
{
  const Halfedge h = mesh.halfedge(f);
  return input.face(input.halfedge(chart.input_vertex(mesh.source(h)), chart.input_vertex(mesh.target(h))));
}

// A chart with the points of the input, so that both sides of a seam share them
inline Textured_surface surface_of_chart(const Mesh& input, const Mesh& mesh, const Chart& chart,
                                         const UV_map& uv)
{
  Textured_surface surface = textured_chart(mesh, chart, uv);
  if(chart.is_cut()) {
    surface.points.assign(input.points().begin(), input.points().end());
    for(std::array<Textured_surface::Index, 3>& triangle : surface.triangles) {
      for(Textured_surface::Index& v : triangle) {
        v = chart.input_vertex(Vertex(v)).idx();
      }
    }
  }
  return surface;
}

} // namespace internal

// `mesh` is the input, or what was cut out of it: that of the chart. `polygons` are those of the faces of the input, in
// the file.
inline Report_contents contents_of_chart(const Command_line& command, const Mesh& input,
                                         const std::vector<Index>& polygons, const Mesh& mesh,
                                         const Chart& chart, const Run_record& record)
{
  const Flattening& flattening = record.flattening;
  Report_contents contents;
  contents.title = std::filesystem::path(record.input).filename().string();
  contents.is_atlas = false;
  contents.rows = surface_rows(record);
  contents.notes = record.notes;
  for(const Vertex v : chart.vertices) {
    contents.box += flattening.uv[v].bbox();
  }
  contents.charts = {{chart.faces.size(), 1, flattening.method, flattening.measures.l2_stretch,
                      scale_stretch(mesh, chart, flattening.uv),
                      record.seams && flattening.method == "direct"
                          ? std::exp(flattening.report.largest_seam_jump)
                          : std::numeric_limits<double>::quiet_NaN()}};
  contents.surface = internal::surface_of_chart(input, mesh, chart, flattening.uv);
  contents.up = up_axis(command, contents.surface);
  for(const Face f : chart.faces) {
    contents.faces.push_back(polygons[internal::face_of_input(input, mesh, chart, f).idx()]);
  }
  return contents;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CONTENTS_OF_CHART_H
