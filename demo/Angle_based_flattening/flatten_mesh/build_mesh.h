// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BUILD_MESH_H
#define FLATTEN_MESH_BUILD_MESH_H

#include "Input_error.h"
#include "Polygon_soup.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/helpers.h>

#include <string>

namespace flatten_mesh {

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Halfedge = Mesh::Halfedge_index;

// The triangulated surface of a polygon soup that `check_polygon_soup()` accepts. Its vertices are those of
// the soup, in the same order; larger polygons are divided into triangles.
inline Mesh build_mesh(const Polygon_soup& soup)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  Mesh mesh;
  PMP::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  if(!CGAL::is_triangle_mesh(mesh)) {
    PMP::triangulate_faces(mesh);
    mesh.collect_garbage();
    for(const Face f : mesh.faces()) {
      if(!CGAL::is_triangle(mesh.halfedge(f), mesh)) {
        throw Input_error("the face at vertices " + std::to_string(mesh.source(mesh.halfedge(f)).idx() + 1) +
                          " and " + std::to_string(mesh.target(mesh.halfedge(f)).idx() + 1) +
                          " cannot be divided into triangles; triangulate the mesh first");
      }
    }
  }
  return mesh;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BUILD_MESH_H
