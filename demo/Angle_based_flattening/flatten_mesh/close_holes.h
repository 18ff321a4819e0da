// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CLOSE_HOLES_H
#define FLATTEN_MESH_CLOSE_HOLES_H

#include "Chart.h"
#include "build_mesh.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/centroid.h>

#include <vector>

namespace flatten_mesh {

// Closes every border of the chart but the outer one, by a fan of triangles around the centre of its vertices. The
// vertices, faces and halfedges of the mesh keep their numbers. A disk can be laid out exactly, while the angles alone
// do not see to it that the gap in the plane closes around a hole.
inline void close_holes(Mesh& mesh, const Chart& chart)
{
  for(const Halfedge hole : chart.borders) {
    if(hole == chart.border) {
      continue;
    }
    std::vector<Kernel::Point_3> points;
    for(const Vertex v : mesh.vertices_around_face(hole)) {
      points.push_back(mesh.point(v));
    }
    CGAL::Euler::fill_hole(hole, mesh);
    const Halfedge spoke = CGAL::Euler::add_center_vertex(hole, mesh);
    mesh.point(mesh.target(spoke)) = CGAL::centroid(points.begin(), points.end());
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CLOSE_HOLES_H
