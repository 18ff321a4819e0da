// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BUILD_MESH_H
#define FLATTEN_MESH_BUILD_MESH_H

#include "read_polygon_soup.h"
#include "texts.h"

// The header that divides faces has one for holes with it, and two more triangulations for these: not used here, they would
// take long to compile.
#define CGAL_HOLE_FILLING_DO_NOT_USE_CDT2
#define CGAL_HOLE_FILLING_DO_NOT_USE_DT3

#include <CGAL/Surface_mesh.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
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

namespace internal {

inline std::string edge_name(const std::size_t v, const std::size_t w)
{
  return "the edge between vertices " + std::to_string((std::min)(v, w) + 1) + " and " +
         std::to_string((std::max)(v, w) + 1);
}

[[noreturn]] inline void refuse_vertex(const std::size_t v)
{
  throw Input_error("at " + vertex_name(v) +
                    " parts of the surface touch in a point, so it is not a manifold; give each part a "
                    "vertex of its own");
}

// Throws if another polygon runs along an edge of the polygon in the same direction: too many have that edge, or the two
// are oriented differently.
inline void check_edge(const Polygon_soup& soup, const std::size_t p, const std::size_t v,
                       const std::size_t w)
{
  std::size_t count = 0, other = p;
  for(std::size_t q = 0; q < soup.polygons.size(); ++q) {
    const Polygon& polygon = soup.polygons[q];
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t from = polygon[i], to = polygon[(i + 1) % polygon.size()];
      const bool is_same = from == v && to == w;
      count += is_same || (from == w && to == v);
      other = is_same && other == p ? q : other;
    }
  }
  if(count > 2) {
    throw Input_error(edge_name(v, w) + " has " + std::to_string(count) +
                      " faces, so the surface is not a manifold; remove or separate the surplus ones");
  }
  if(other != p) {
    throw Input_error("faces " + std::to_string((std::min)(p, other) + 1) + " and " +
                      std::to_string((std::max)(p, other) + 1) +
                      " are oriented differently: both run along " + edge_name(v, w) +
                      " in the same direction; orient all faces alike");
  }
}

// Says why the mesh of the polygons before did not take this one.
[[noreturn]] inline void refuse_polygon(const Polygon_soup& soup, const std::size_t p, const Mesh& mesh)
{
  const Polygon& polygon = soup.polygons[p];
  if(polygon.size() < 3) {
    throw Input_error(face_name(p) + " has fewer than three vertices; remove it");
  }
  Polygon sorted(polygon);
  std::sort(sorted.begin(), sorted.end());
  const Polygon::const_iterator twice = std::adjacent_find(sorted.begin(), sorted.end());
  if(twice != sorted.end()) {
    throw Input_error(face_name(p) + " has " + vertex_name(*twice) + " twice; remove degenerate faces");
  }
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    check_edge(soup, p, polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  // A vertex whose faces are complete without this one, or would be and leave out others
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
  for(std::size_t v = 0; v < soup.points.size(); ++v) {
    const Kernel::Point_3& point = soup.points[v];
    if(!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z())) {
      throw Input_error(vertex_name(v) +
                        " has a coordinate that is not a finite number; remove it or repair the scan");
    }
    mesh.add_vertex(point);
  }
}

// The largest number of polygons at a vertex. Throws if a polygon has a vertex that is not there.
inline std::size_t largest_valence(const Polygon_soup& soup)
{
  std::vector<std::size_t> valence(soup.points.size(), 0);
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    for(const std::size_t v : soup.polygons[p]) {
      if(v >= soup.points.size()) {
        throw Input_error(face_name(p) + " has a vertex that is not there: the file has only " +
                          std::to_string(soup.points.size()) + "; export the mesh again");
      }
      ++valence[v];
    }
  }
  return *std::max_element(valence.begin(), valence.end());
}

// Adding faces one by one names the first that does not fit, but takes quadratic time at a vertex with many of them.
inline void add_faces(const Polygon_soup& soup, Mesh& mesh)
{
  const std::size_t large_valence = 1000;
  if(largest_valence(soup) > large_valence &&
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
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
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

} // namespace internal

// The triangulated surface of a polygon soup. Its vertices are those of the soup, in the same order; larger polygons are
// divided into triangles. Throws an `Input_error` that names the place unless the polygons form an oriented manifold
// with finite coordinates.
inline Mesh build_mesh(const Polygon_soup& soup)
{
  if(soup.points.empty() || soup.polygons.empty()) {
    throw Input_error(
        soup.points.empty()
            ? "the file has no vertices; export the mesh again"
            : "the file has vertices but no faces; a point cloud has to be made into a surface first");
  }
  Mesh mesh;
  internal::add_vertices(soup, mesh);
  internal::add_faces(soup, mesh);
  std::vector<Halfedge> at_pinched_vertices;
  CGAL::Polygon_mesh_processing::non_manifold_vertices(mesh, std::back_inserter(at_pinched_vertices));
  if(!at_pinched_vertices.empty()) {
    internal::refuse_vertex(mesh.target(at_pinched_vertices.front()));
  }
  internal::triangulate(mesh);
  return mesh;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BUILD_MESH_H
