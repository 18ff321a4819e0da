// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BUILD_MESH_H
#define FLATTEN_MESH_BUILD_MESH_H

#include "Notes.h"
#include "Polygon_soup.h"
#include "check_polygons.h"
#include "repair_soup.h"
#include "texts.h"

// The header that triangulates faces includes one for holes with two further triangulations. They are not needed
// here, and slow to compile.
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3

#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
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

// Returns why this polygon could not be added to the mesh of the previous ones.
[[noreturn]] inline void refuse_polygon(const Polygon_soup& soup, const std::size_t p, const Mesh& mesh)
{
  const Polygon& polygon = soup.polygons[p];
  check_polygon(soup, p);
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    check_edge(soup, p, polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  // A vertex whose faces are closed without this one, or would be closed with it and exclude others
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const Vertex v(polygon[i]), next(polygon[(i + 1) % polygon.size()]),
        previous(polygon[(i + polygon.size() - 1) % polygon.size()]);
    const Halfedge to = mesh.halfedge(previous, v), from = mesh.halfedge(v, next);
    const bool is_complete = !mesh.is_isolated(v) && !mesh.is_border(v);
    if(is_complete || (to.is_valid() && from.is_valid() && mesh.next(to) != from)) {
      refuse_vertex(v);
    }
  }
  refuse_vertex(polygon[0]);
}

inline void add_vertices(const Polygon_soup& soup, Mesh& mesh)
{
  for(const Kernel::Point_3& point : soup.points) {
    mesh.add_vertex(point);
  }
}

// Adding faces one by one finds the first that does not fit, but takes quadratic time at a vertex with many faces.
inline void add_faces(const Polygon_soup& soup, Mesh& mesh)
{
  const std::size_t large_valence = 1000;
  const std::vector<std::size_t> valence = valences(soup);
  if(*std::max_element(valence.begin(), valence.end()) > large_valence &&
     CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(soup.polygons)) {
    std::vector<std::vector<Vertex>> faces;
    for(const Polygon& polygon : soup.polygons) {
      faces.emplace_back(polygon.begin(), polygon.end());
    }
    CGAL::Euler::add_faces(faces, mesh);
    return;
  }
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const Polygon& polygon = soup.polygons[p];
    if(mesh.add_face(std::vector<Vertex>(polygon.begin(), polygon.end())) == Mesh::null_face()) {
      refuse_polygon(soup, p, mesh);
    }
  }
}

inline void triangulate(Mesh& mesh)
{
  if(CGAL::is_triangle_mesh(mesh)) {
    return;
  }
  const std::size_t number_of_sides = mesh.number_of_edges();
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  const Edge_marks is_diagonal = diagonals(mesh);
  for(const Edge e : mesh.edges()) {
    is_diagonal[e] = e.idx() >= number_of_sides; // new edges come last
  }
  mesh.collect_garbage();
  for(const Face f : mesh.faces()) {
    const Halfedge h = mesh.halfedge(f);
    if(!CGAL::is_triangle(h, mesh)) {
      throw Input_error("the face at vertices " + std::to_string(mesh.source(h).idx() + 1) + " and " +
                        std::to_string(mesh.target(h).idx() + 1) +
                        " cannot be divided into triangles; triangulate the mesh first");
    }
  }
}

// Throws a `Not_a_mesh` if the polygons do not fit together.
inline Mesh build_polygon_mesh(const Polygon_soup& soup)
{
  Mesh mesh;
  add_vertices(soup, mesh);
  add_faces(soup, mesh);
  std::vector<Halfedge> at_pinched_vertices;
  CGAL::Polygon_mesh_processing::non_manifold_vertices(mesh, std::back_inserter(at_pinched_vertices));
  if(!at_pinched_vertices.empty()) {
    refuse_vertex(mesh.target(at_pinched_vertices.front()));
  }
  return mesh;
}

inline Mesh build_repaired_mesh(Polygon_soup& soup, Notes& notes)
{
  weld_soup(soup, notes);
  try {
    return build_polygon_mesh(soup);
  } catch(const Not_a_mesh&) {
    orient_soup(soup, notes);
    return build_polygon_mesh(soup);
  }
}

} // namespace internal

// The triangulated surface of a polygon soup, which is repaired if necessary and requested. Its vertices are those of
// the soup, in the same order; larger polygons are divided into triangles. Throws an `Input_error` that names the
// place unless the polygons form an oriented manifold with finite coordinates.
inline Mesh build_mesh(Polygon_soup& soup, const bool repair, Notes& notes)
{
  if(soup.points.empty() || soup.polygons.empty()) {
    throw Input_error(
        soup.points.empty()
            ? "the file has no vertices; export the mesh again"
            : "the file has vertices but no faces; a point cloud has to be made into a surface first");
  }
  internal::check_points(soup);
  Mesh mesh = repair ? internal::build_repaired_mesh(soup, notes) : internal::build_polygon_mesh(soup);
  internal::triangulate(mesh);
  return mesh;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BUILD_MESH_H
