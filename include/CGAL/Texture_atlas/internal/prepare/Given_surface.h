// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_GIVEN_SURFACE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_GIVEN_SURFACE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// A soup and the surface that was made of it, alone or as one of several in a common mesh
struct Given_surface
{
  const Surface_soup& soup;
  Prepared_surface& surface;
  std::string name; // for messages
  std::size_t first_face = 0, first_halfedge = 0;

  Halfedge in_common_mesh(const Halfedge h) const
  {
    return Halfedge(static_cast<Mesh::size_type>(first_halfedge + h.idx()));
  }

  Edge in_common_mesh(const Edge e) const
  {
    return Edge(static_cast<Mesh::size_type>(first_halfedge / 2 + e.idx()));
  }

  Face in_common_mesh(const Face f) const { return Face(static_cast<Mesh::size_type>(first_face + f.idx())); }
};

// Adds a surface to a common mesh.
inline void append(Given_surface& given, Mesh& common)
{
  given.first_face = common.number_of_faces();
  given.first_halfedge = common.number_of_halfedges();
  common += given.surface.mesh;
  const Edge_marks is_diagonal = diagonals(given.surface.mesh), is_diagonal_of_common = diagonals(common);
  for(const Edge e : given.surface.mesh.edges()) {
    is_diagonal_of_common[given.in_common_mesh(e)] = is_diagonal[e];
  }
}

// The one that a face of the common mesh is part of
inline std::size_t surface_of_face(const std::vector<Given_surface>& given, const Face f)
{
  const auto after =
      std::upper_bound(given.begin(), given.end(), f.idx(),
                       [](const std::size_t i, const Given_surface& each) { return i < each.first_face; });
  return static_cast<std::size_t>(after - given.begin()) - 1;
}

// The polygon of its soup that a face of the common mesh is part of
inline std::size_t polygon_of_face(const std::vector<Given_surface>& given, const Face f)
{
  const Given_surface& each = given[surface_of_face(given, f)];
  const Mesh& mesh = each.surface.mesh;
  const Face own(static_cast<Mesh::size_type>(f.idx() - each.first_face));
  return each.soup.polygon_of_corner(each.surface.origins.corners[mesh.halfedge(own).idx()]);
}

// The point of its soup that a halfedge of the common mesh ends at, in a face of this surface
inline Index point_of_corner(const Given_surface& given, const Halfedge h)
{
  return given.soup.vertices[given.surface.origins.corners[h.idx() - given.first_halfedge]];
}

// Sets the numbers of all vertices with faces, and of all faces.
inline void number_as_in_soups(const std::vector<Given_surface>& given, Mesh& mesh)
{
  const Soup_numbers numbers = soup_numbers(mesh);
  for(const Face f : mesh.faces()) {
    numbers.polygons[f] = polygon_of_face(given, f) + 1;
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      numbers.points[mesh.target(h)] = point_of_corner(given[surface_of_face(given, f)], h) + std::size_t(1);
    }
  }
}

// The part of the common atlas that belongs to a surface, as properties of its own mesh
inline Atlas atlas_of_surface(const Atlas& whole, const Given_surface& given)
{
  Mesh& mesh = given.surface.mesh;
  Atlas atlas = empty_atlas(mesh);
  for(const Halfedge h : mesh.halfedges()) {
    atlas.uv[h] = whole.uv[given.in_common_mesh(h)];
  }
  for(const Face f : mesh.faces()) {
    atlas.chart[f] = whole.chart[given.in_common_mesh(f)];
  }
  for(const Edge e : mesh.edges()) {
    atlas.seams[e] = whole.seams[given.in_common_mesh(e)];
  }
  return atlas;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_GIVEN_SURFACE_H
