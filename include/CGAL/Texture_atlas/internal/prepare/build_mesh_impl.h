// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_BUILD_MESH_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_BUILD_MESH_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>
#include <CGAL/Texture_atlas/internal/prepare/check_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/separate_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/triangulate.h>
#include <CGAL/Texture_atlas/internal/prepare/weld_soup.h>

#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

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
      refuse_vertex(soup, v);
    }
  }
  refuse_vertex(soup, polygon[0]);
}

// Takes memory for about as many edges as Euler's formula tells.
inline void add_vertices(const Polygon_soup& soup, Mesh& mesh)
{
  const std::size_t vertices = soup.points.size(), faces = soup.polygons.size(), both = vertices + faces;
  const auto size = [](const std::size_t number) { return static_cast<Mesh::size_type>(number); };
  mesh.reserve(size(vertices), size(both + both / 64), size(faces));
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

// Throws a `Not_a_mesh` if the polygons do not fit together.
inline Mesh build_polygon_mesh(const Polygon_soup& soup)
{
  Mesh mesh;
  add_vertices(soup, mesh);
  add_faces(soup, mesh);
  std::vector<Halfedge> at_pinched_vertices;
  CGAL::Polygon_mesh_processing::non_manifold_vertices(mesh, std::back_inserter(at_pinched_vertices));
  if(!at_pinched_vertices.empty()) {
    refuse_vertex(soup, mesh.target(at_pinched_vertices.front()));
  }
  return mesh;
}

inline Mesh build_repaired_mesh(const Surface_soup& model, const Welding& welding, Polygon_soup& soup,
                                Notes& notes)
{
  if(soup.is_welded) {
    leave_out_collapsed(soup);
  }
  weld_soup(welding, soup, notes);
  if(soup.polygons.empty()) {
    throw Input_error(
        "every face has two corners at the same place, so there is no surface; export the mesh again");
  }
  try {
    return build_polygon_mesh(soup);
  } catch(const Not_a_mesh&) {
    for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
      check_polygon(soup, p);
    }
    leave_out_duplicates(soup);
    separate_backs(soup, notes);
    separate_soup(model, soup, notes);
    return build_polygon_mesh(soup);
  }
}

inline void check_not_empty(const Polygon_soup& soup)
{
  if(soup.points.empty() || soup.polygons.empty()) {
    throw Input_error(
        soup.points.empty()
            ? "there are no vertices; export the mesh again"
            : "there are vertices but no faces; a point cloud has to be made into a surface first",
        {}, {}, Diagnosis::EMPTY_MESH);
  }
}

inline std::string undivided_text(const Index polygon)
{
  return face_name(polygon) + " cannot be divided into triangles: other edges join its corners already";
}

// Triangulates the mesh of a soup. `undivided` receives the polygons of the soup for which that is not possible.
inline Surface_of_model end_surface(const Surface_soup& model, const Polygon_soup& soup, Mesh mesh,
                                    std::vector<std::size_t>& undivided)
{
  Surface_of_model surface;
  surface.mesh = std::move(mesh);
  surface.origins = origins_of_polygons(model, soup, surface.mesh);
  for(const Face f : triangulate(surface.mesh)) {
    undivided.push_back(f.idx());
  }
  add_origins_of_diagonals(surface.mesh, surface.origins);
  return surface;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Surface_of_model build_mesh(const Surface_soup& model, Polygon_soup& soup,
                                                               const bool repair, Notes& notes,
                                                               const Welding& welding)
{
  check_not_empty(soup);
  check_points(soup);
  Mesh mesh = repair ? build_repaired_mesh(model, welding, soup, notes) : build_polygon_mesh(soup);
  std::vector<std::size_t> undivided;
  Surface_of_model surface = end_surface(model, soup, std::move(mesh), undivided);
  if(!undivided.empty()) {
    throw Input_error(undivided_text(soup.origins[undivided.front()]) + "; triangulate it first");
  }
  return surface;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE void divide_polygons(Surface_of_model& surface)
{
  for(const Halfedge h : surface.mesh.halfedges()) {
    surface.origins.corners.push_back(surface.mesh.is_border(h) ? no_index : static_cast<Index>(h.idx()));
  }
  triangulate(surface.mesh);
  add_origins_of_diagonals(surface.mesh, surface.origins);
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_BUILD_MESH_IMPL_H
