// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXTURED_CHART_H
#define FLATTEN_MESH_TEXTURED_CHART_H

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/pictures/Textured_surface.h"
#include "flatten_mesh/model/build_mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace flatten_mesh {

// Faces with coordinates at their vertices, as one chart without borders. All points of the mesh are kept.
template <class UV_map>
Textured_surface textured_faces(const Mesh& mesh, const std::vector<Face>& faces, const UV_map& uv)
{
  Textured_surface surface;
  surface.points.assign(mesh.points().begin(), mesh.points().end());
  surface.charts.assign(faces.size(), 0);
  for(const Face f : faces) {
    surface.triangles.emplace_back();
    surface.uv.emplace_back();
    Halfedge h = mesh.halfedge(f);
    for(std::size_t i = 0; i < 3; ++i, h = mesh.next(h)) {
      surface.triangles.back()[i] = mesh.source(h).idx();
      surface.uv.back()[i] = uv[mesh.source(h)];
    }
  }
  return surface;
}

// A chart with its borders
template <class UV_map>
Textured_surface textured_chart(const Mesh& mesh, const Chart& chart, const UV_map& uv)
{
  using Side = Textured_surface::Side;
  Textured_surface surface = textured_faces(mesh, chart.faces, uv);
  std::vector<Side> sides(mesh.number_of_halfedges()); // of each halfedge of the chart
  for(std::size_t t = 0; t < chart.faces.size(); ++t) {
    Halfedge h = mesh.halfedge(chart.faces[t]);
    for(std::uint8_t i = 0; i < 3; ++i, h = mesh.next(h)) {
      sides[h.idx()] = {static_cast<Textured_surface::Index>(t), i, chart.seam(mesh.edge(h))};
    }
  }
  for(const Halfedge border : chart.borders) {
    surface.borders.push_back({0, {}});
    Halfedge h = border;
    do { // against the direction of the border, which runs around the outside
      surface.borders.back().sides.push_back(sides[mesh.opposite(h).idx()]);
      h = mesh.prev(h);
    } while(h != border);
  }
  return surface;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TEXTURED_CHART_H
