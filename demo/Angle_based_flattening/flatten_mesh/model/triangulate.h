// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TRIANGULATE_H
#define FLATTEN_MESH_TRIANGULATE_H

#include "flatten_mesh/model/Corner_origins.h"
#include "flatten_mesh/texts.h"

// The header that triangulates faces includes one for holes with two further triangulations. They are not needed
// here, and slow to compile.
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

using Edge_marks = Mesh::Property_map<Edge, bool>;

// The edges along which a mesh is cut open.
inline Edge_marks seam_marks(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>("e:flatten_mesh_seam", false).first;
}

// The edges that divide larger polygons into triangles.
inline Edge_marks diagonals(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>("e:flatten_mesh_diagonal", false).first;
}

namespace internal {

// From the first corner whose diagonals are no edges yet
inline void divide_as_fan(Mesh& mesh, const Face f)
{
  Halfedge corner = mesh.halfedge(f);
  for(const Halfedge h : mesh.halfedges_around_face(corner)) {
    bool is_free = true;
    for(Halfedge o = mesh.next(mesh.next(h)); mesh.next(o) != h; o = mesh.next(o)) {
      is_free = is_free && !mesh.halfedge(mesh.target(h), mesh.target(o)).is_valid();
    }
    if(is_free) {
      corner = h;
      break;
    }
  }
  while(!CGAL::is_triangle(corner, mesh)) {
    CGAL::Euler::split_face(corner, mesh.next(mesh.next(corner)), mesh);
  }
}

// CGAL does not divide all faces: those without area remain.
inline std::vector<Face> larger_faces(const Mesh& mesh)
{
  std::vector<Face> faces;
  for(const Face f : mesh.faces()) {
    if(!CGAL::is_triangle(mesh.halfedge(f), mesh)) {
      faces.push_back(f);
    }
  }
  return faces;
}

// Throws an `Input_error` that names a face which cannot be divided, unless all are to be divided in any way.
inline void triangulate(Mesh& mesh, const bool divides_all)
{
  if(CGAL::is_triangle_mesh(mesh)) {
    return;
  }
  const std::size_t number_of_sides = mesh.number_of_edges();
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  for(const Face f : divides_all ? larger_faces(mesh) : std::vector<Face>()) {
    divide_as_fan(mesh, f);
  }
  const Edge_marks is_diagonal = diagonals(mesh);
  for(const Edge e : mesh.edges()) {
    is_diagonal[e] = e.idx() >= number_of_sides; // new edges come last
  }
  mesh.collect_garbage();
  const std::vector<Face> faces = larger_faces(mesh);
  if(!faces.empty()) {
    const Halfedge h = mesh.halfedge(faces.front());
    throw Input_error("the face at vertices " + std::to_string(mesh.source(h).idx() + 1) + " and " +
                      std::to_string(mesh.target(h).idx() + 1) +
                      " cannot be divided into triangles; triangulate the mesh first");
  }
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TRIANGULATE_H
