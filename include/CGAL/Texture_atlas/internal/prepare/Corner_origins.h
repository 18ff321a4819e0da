// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CORNER_ORIGINS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CORNER_ORIGINS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// A triangle of a mesh in a polygon of a model, as corners of the model. Turned triangles are turned as in the mesh.
struct Model_triangle
{
  Index polygon;
  std::array<Index, 3> corners;
};

// Where the triangles of a mesh are in the model that it was made of, after any repairs.
struct Corner_origins
{
  std::vector<Index> corners;  // of each halfedge: the corner at its target. `no_index` on borders
  std::vector<bool> is_turned; // of each polygon of the model: the mesh has its corners in reverse order
  std::vector<bool>
      has_no_area; // of each polygon of the model: the mesh is therefore without it. Empty if none is so

  Model_triangle triangle(const Surface_soup& model, const Mesh& mesh, const Face f) const
  {
    const Halfedge h = mesh.halfedge(f), next = mesh.next(h), last = mesh.next(next);
    return {model.polygon_of_corner(corners[h.idx()]),
            {corners[h.idx()], corners[next.idx()], corners[last.idx()]}};
  }
};

// Of each face of a mesh, the polygon of the model that it is in
inline std::vector<Index> polygons_of_faces(const Surface_soup& model, const Mesh& mesh,
                                            const Corner_origins& origins)
{
  std::vector<Index> polygons;
  polygons.reserve(mesh.number_of_faces());
  for(const Face f : mesh.faces()) {
    polygons.push_back(model.polygon_of_corner(origins.corners[mesh.halfedge(f).idx()]));
  }
  return polygons;
}

// The polygons, `polygon_of(f)`, of the faces without chart that hang together with one of them
template <class Polygon_of>
std::set<std::size_t> polygons_of_part(const Mesh& mesh, const Edge_marks& seams,
                                       const Mesh::Property_map<Face, int>& charts, const Face first,
                                       const Polygon_of& polygon_of)
{
  std::set<std::size_t> polygons;
  std::set<Face> faces = {first};
  for(std::vector<Face> stack = {first}; !stack.empty();) {
    const Face f = stack.back();
    stack.pop_back();
    polygons.insert(polygon_of(f));
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Face next = mesh.face(mesh.opposite(h));
      if(next != Mesh::null_face() && charts[next] < 0 && !seams[mesh.edge(h)] && faces.insert(next).second) {
        stack.push_back(next);
      }
    }
  }
  return polygons;
}

// The corner of a polygon of a soup, in the model.
inline Index corner_in_model(const Surface_soup& model, const Polygon_soup& soup, const std::size_t polygon,
                             const std::size_t corner)
{
  const std::size_t size = soup.polygons[polygon].size(),
                    i = soup.is_turned[polygon] ? size - 1 - corner : corner;
  const auto corners = soup.corners.find(polygon);
  return corners != soup.corners.end() ? corners->second[i]
                                       : model.first_corners[soup.origins[polygon]] + static_cast<Index>(i);
}

// Of a mesh whose faces are still the polygons of the soup, in their order.
inline Corner_origins origins_of_polygons(const Surface_soup& model, const Polygon_soup& soup,
                                          const Mesh& mesh)
{
  Corner_origins origins;
  origins.corners.assign(mesh.number_of_halfedges(), no_index);
  origins.is_turned.assign(model.number_of_polygons(), false);
  for(const Face f : mesh.faces()) {
    const std::size_t p = f.idx();
    const Polygon& polygon = soup.polygons[p];
    Halfedge h = mesh.halfedge(f);
    const auto first = std::find(polygon.begin(), polygon.end(), std::size_t(mesh.target(h)));
    for(std::size_t i = 0; i < polygon.size(); ++i, h = mesh.next(h)) {
      const std::size_t corner = (static_cast<std::size_t>(first - polygon.begin()) + i) % polygon.size();
      origins.corners[h.idx()] = corner_in_model(model, soup, p, corner);
    }
    origins.is_turned[soup.origins[p]] = soup.is_turned[p];
  }
  return origins;
}

// After the polygons were divided into triangles, the new halfedges get the corners, too. The sides of the polygons
// keep theirs: all triangles at a corner lie, one after the other, behind the side that ends there.
inline void add_origins_of_diagonals(const Mesh& mesh, Corner_origins& origins)
{
  const std::size_t sides = origins.corners.size();
  origins.corners.resize(mesh.number_of_halfedges(), no_index);
  for(std::size_t i = 0; i < sides; ++i) {
    if(origins.corners[i] != no_index) {
      Halfedge h(static_cast<Mesh::size_type>(i));
      while(mesh.next(h).idx() >= sides) {
        h = mesh.opposite(mesh.next(h));
        origins.corners[h.idx()] = origins.corners[i];
      }
    }
  }
}

using Report_on_atlas = Mesh_atlas_report<Mesh>;

// The numbers of the points and polygons of a soup that vertices and faces are, in messages: from 1
struct Soup_numbers
{
  Mesh::Property_map<Vertex, std::size_t> points;
  Mesh::Property_map<Face, std::size_t> polygons;
};

inline Soup_numbers soup_numbers(Mesh& mesh)
{
  return {mesh.add_property_map<Vertex, std::size_t>("v:flatten_mesh_number", 0).first,
          mesh.add_property_map<Face, std::size_t>("f:flatten_mesh_number", 0).first};
}

// The charts of a mesh, as properties of it
struct Atlas
{
  Mesh::Property_map<Halfedge, Kernel::Point_2> uv; // at the target of a halfedge in its face
  Mesh::Property_map<Face, int> chart;              // from 0 on; -1 without one
  Edge_marks seams;
};

inline Atlas empty_atlas(Mesh& mesh)
{
  return {mesh.add_property_map<Halfedge, Kernel::Point_2>("h:flatten_mesh_uv").first,
          mesh.add_property_map<Face, int>("f:flatten_mesh_chart", -1).first, seam_marks(mesh)};
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_CORNER_ORIGINS_H
