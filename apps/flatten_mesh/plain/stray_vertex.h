// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_STRAY_VERTEX_H
#define FLATTEN_MESH_STRAY_VERTEX_H

#include "flatten_mesh/plain/Sheet.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace flatten_mesh {

// Scanners often put a vertex that they did not measure at the origin. Its faces are needles, for which a map needs a
// huge range of scales. Returns a text that names the vertex with the sharpest needles, and is empty if even there the
// shortest edge is less than ten times as long as all edges around the vertex together.
inline std::string stray_vertex_text(const Sheet& sheet)
{
  const Mesh& mesh = sheet.mesh();
  const auto length = [&](const Vertex v, const Vertex w) {
    return std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w)));
  };
  Vertex stray = sheet.vertices.front();
  double largest_ratio = 0;
  for(const Vertex v : sheet.vertices) {
    double shortest = std::numeric_limits<double>::infinity(), around = 0;
    for(const Halfedge h : CGAL::halfedges_around_target(v, mesh)) {
      shortest = (std::min)(shortest, length(v, mesh.source(h)));
      if(!mesh.is_border(h)) {
        around += length(mesh.source(h), mesh.source(mesh.prev(h)));
      }
    }
    if(around > 0 && shortest > largest_ratio * around) {
      largest_ratio = shortest / around;
      stray = v;
    }
  }
  const Kernel::Point_3& point = mesh.point(stray);
  return largest_ratio < 10
             ? ""
             : "; or remove " + vertex_name(sheet.input_vertex(stray).idx()) + ", at (" +
                   format_number("%.6g", point.x()) + ", " + format_number("%.6g", point.y()) + ", " +
                   format_number("%.6g", point.z()) + "), which is " + format_number("%.3g", largest_ratio) +
                   " times as far from its neighbors as these are around it";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_STRAY_VERTEX_H
