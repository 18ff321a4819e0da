// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The certificate for any mesh with coordinates, whoever flattened it, with the proof that its tests suffice.
// Included by `certify_flattening.h`, the public function for maps of all methods.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_crossings.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Coordinates of vertices or of halfedges. A halfedge of a face has those of its target at that face, and the surface is cut open along
// the edges whose two sides have different coordinates. Vertices of a `Seam_mesh` may be keys as halfedges of the mesh below it.
template <typename TriangleMesh, typename UVMap>
class Corner_coordinates
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

public:
  static constexpr bool are_at_vertices =
      !std::is_same<typename boost::property_traits<UVMap>::key_type, halfedge_descriptor>::value;

  Corner_coordinates(const TriangleMesh& mesh, UVMap uv) : m_mesh(mesh), m_uv(uv) {}

  decltype(auto) operator[](halfedge_descriptor h) const
  {
    if constexpr(are_at_vertices)
      return get(m_uv, target(h, m_mesh));
    else
      return get(m_uv, h);
  }

  // Whether the map ends at the edge of a halfedge that has a face
  bool is_at_border(halfedge_descriptor h) const
  {
    const halfedge_descriptor other = opposite(h, m_mesh);
    if(CGAL::is_border(other, m_mesh))
      return true;
    if constexpr(are_at_vertices)
      return false;
    else
      return get(m_uv, h) != get(m_uv, prev(other, m_mesh)) || get(m_uv, other) != get(m_uv, prev(h, m_mesh));
  }

private:
  const TriangleMesh& m_mesh;
  UVMap m_uv;
};

// Faces of a mesh, drawn in the plane: all that the certificate looks at.
template <typename TriangleMesh, typename UVMap>
class Planar_map
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef Exact_point<typename boost::property_traits<UVMap>::value_type> Convert;

public:
  typedef typename Convert::type Point_2;

  // `faces` must consist of connected components. Throws `std::invalid_argument` if a face is not a triangle.
  template <typename FaceRange>
  Planar_map(const TriangleMesh& mesh, const FaceRange& faces, UVMap uvmap)
  {
    typedef Corner_coordinates<TriangleMesh, UVMap> Coordinates;
    const Coordinates coordinates(mesh, uvmap);
    const auto corner = get(CGAL::dynamic_halfedge_property_t<int>(), mesh);
    std::vector<halfedge_descriptor> halfedges;
    for(face_descriptor f : faces) {
      halfedge_descriptor h = halfedge(f, mesh);
      if(next(next(next(h, mesh), mesh), mesh) != h)
        throw std::invalid_argument("a face is not a triangle");
      face_descriptors.push_back(f);
      for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
        put(corner, h, static_cast<int>(halfedges.size()));
        halfedges.push_back(h);
      }
    }
    for(halfedge_descriptor h : halfedges)
      across.push_back(coordinates.is_at_border(h) ? -1 : get(corner, opposite(h, mesh)));
    if constexpr(Coordinates::are_at_vertices)
      number_vertices_of_mesh(mesh, halfedges);
    else
      number_vertices_of_fans(mesh, halfedges, corner);
    for(std::size_t c = 0; c < halfedges.size(); ++c) {
      if(vertex[c] == static_cast<int>(points.size())) // its first corner
        points.push_back(Convert::get(coordinates[halfedges[c]]));
      if(across[c] < 0)
        border_halfedges.push_back(opposite(halfedges[c], mesh));
    }
    for(std::size_t c = 0; c < halfedges.size(); ++c)
      if(across[c] < 0)
        border.push_back({vertex[get(corner, prev(halfedges[c], mesh))], vertex[c]});
  }

  bool is_locally_injective() const
  {
    return flipped_triangles(vertex, points).empty() && is_injective_at_vertices(vertex, border, points);
  }

  // Theorem. The map is injective and keeps the orientation if and only if every triangle is positively oriented, no two
  // border edges touch, and the border winds around no point more than once.
  //
  // Proof. The border of a positively oriented triangle winds once around the points within it, and not around those
  // without. Summed over all triangles, edges between two of them cancel: the border winds around a point that is on no
  // edge as often as triangles contain it. If that is twice, or border edges touch, the map is not injective.
  // Conversely, let two points of the surface have the same image. If no border edges touch, one of the two is not on the
  // border, and has a neighbourhood that covers one of the image. Triangles at the other point cover a part of that
  // again, around which the border winds twice.
  //
  // This holds for any number of borders and components, and whether or not vertices are manifold. On a connected
  // surface, it means that one border turns left and all others turn right: the winding numbers are not negative, and so
  // the holes are within the outer border and apart. That does not follow from borders that are simple and apart:
  // two sheets glued crosswise along a cut have two that turn left.
  bool is_injective() const
  {
    return flipped_triangles(vertex, points).empty() && bounds_region(border, points);
  }

  std::vector<face_descriptor> face_descriptors;     // of each triangle
  std::vector<halfedge_descriptor> border_halfedges; // of each border edge
  std::vector<Point_2> points;                       // of each vertex
  std::vector<int> vertex;                           // of each corner: the target of a halfedge
  std::vector<int> across; // of each corner: one of the triangle behind the edge of its halfedge, or -1
  std::vector<Border_edge> border;

private:
  // Numbers vertices in the order of their first corners.
  void number_vertices_of_mesh(const TriangleMesh& mesh, const std::vector<halfedge_descriptor>& halfedges)
  {
    const auto number = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
    for(halfedge_descriptor h : halfedges)
      put(number, target(h, mesh), -1);
    int count = 0;
    for(halfedge_descriptor h : halfedges) {
      if(get(number, target(h, mesh)) < 0)
        put(number, target(h, mesh), count++);
      vertex.push_back(get(number, target(h, mesh)));
    }
  }

  // A vertex is a fan of corners between two borders, or around a vertex of the mesh.
  template <typename CornerMap>
  void number_vertices_of_fans(const TriangleMesh& mesh, const std::vector<halfedge_descriptor>& halfedges,
                               const CornerMap& corner)
  {
    Disjoint_sets sets(halfedges.size());
    for(std::size_t c = 0; c < halfedges.size(); ++c)
      if(across[c] >= 0)
        sets.union_set(c, static_cast<std::size_t>(get(corner, prev(opposite(halfedges[c], mesh), mesh))));
    std::vector<int> number(halfedges.size(), -1);
    int count = 0;
    for(std::size_t c = 0; c < halfedges.size(); ++c) {
      int& v = number[sets.find_set(c)];
      if(v < 0)
        v = count++;
      vertex.push_back(v);
    }
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H
