// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SEAM_JUMP_H
#define FLATTEN_MESH_SEAM_JUMP_H

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/Run_record.h"

#include <CGAL/squared_distance_2.h>

#include <algorithm>
#include <cmath>

namespace flatten_mesh {

// The largest difference between the logarithms of the lengths of both sides of an edge on a seam
inline double seam_jump(const Mesh& mesh, const Chart& chart, const UV_map& uv)
{
  const auto squared_length = [&](const Halfedge h) {
    return CGAL::squared_distance(uv[mesh.source(h)], uv[mesh.target(h)]);
  };
  const auto is_in_chart = [&](const Halfedge h) {
    return std::binary_search(chart.vertices.begin(), chart.vertices.end(), mesh.target(h));
  };
  double jump = 0;
  for(const Halfedge h : mesh.halfedges()) {
    const Halfedge other = chart.seam_sides.empty() ? Mesh::null_halfedge() : chart.seam_sides[h.idx()];
    if(other != Mesh::null_halfedge() && is_in_chart(h) && is_in_chart(other)) {
      jump = (std::max)(jump, std::abs(std::log(squared_length(h) / squared_length(other))) / 2);
    }
  }
  return jump;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SEAM_JUMP_H
