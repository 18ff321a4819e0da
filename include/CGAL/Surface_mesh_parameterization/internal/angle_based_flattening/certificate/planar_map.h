// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The certificate for any mesh with coordinates, from any method, with the proof that its tests suffice. Included by
// `certify_flattening.h`, the public function for maps of all methods.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Coordinates of vertices or of halfedges. A halfedge of a face has those of its target at that face, and the surface
// is cut open along the edges whose two sides have different coordinates. Vertices of a `Seam_mesh` may be keys as
// halfedges of the mesh below it.
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

  // `faces` must consist of connected components. Faces that are not triangles are set aside.
  template <typename FaceRange>
  Planar_map(const TriangleMesh& mesh, const FaceRange& faces, UVMap uvmap)
      : m_mesh(mesh), m_coordinates(mesh, uvmap)
  {
    for(face_descriptor f : faces) {
      const halfedge_descriptor h = halfedge(f, mesh), g = next(h, mesh), i = next(g, mesh);
      if(next(i, mesh) != h || i == h) {
        polygons.emplace_back(face_descriptors.size(), f);
        continue;
      }
      face_descriptors.push_back(f);
      m_halfedges.insert(m_halfedges.end(), {h, g, i});
    }
    number_vertices();
    for(std::size_t c = 0; c < m_halfedges.size(); ++c) {
      if(vertex[c] == static_cast<int>(points.size())) // its first corner
        points.push_back(Convert::get(m_coordinates[m_halfedges[c]]));
      if(m_coordinates.is_at_border(m_halfedges[c])) {
        border_halfedges.push_back(opposite(m_halfedges[c], mesh));
        border.push_back({vertex[c % 3 == 0 ? c + 2 : c - 1], vertex[c]});
      }
    }
  }

  // Of each corner: that of the opposite halfedge, or -1 at borders and polygons
  std::vector<int> opposite_corners() const
  {
    const int number_of_corners = static_cast<int>(m_halfedges.size());
    const auto corner = get(CGAL::dynamic_halfedge_property_t<int>(), m_mesh);
    number_corners(corner);
    std::vector<int> result;
    result.reserve(m_halfedges.size());
    for(halfedge_descriptor h : m_halfedges) {
      const int across = m_coordinates.is_at_border(h) ? -1 : get(corner, opposite(h, m_mesh));
      result.push_back(across < number_of_corners ? across : -1);
    }
    return result;
  }

  bool is_locally_injective() const
  {
    return polygons.empty() && flipped_triangles(vertex, points).empty() &&
           is_injective_at_vertices(vertex, border, points);
  }

  // Theorem. The map is injective and keeps the orientation if and only if every triangle is positively oriented, no
  // two border edges touch, and the border winds around no point more than once.
  //
  // Proof. The border of a positively oriented triangle winds once around the points within it, and not around those
  // without. Summed over all triangles, edges between two of them cancel: the border winds around a point that is on no
  // edge as often as triangles contain it. If that is twice, or border edges touch, the map is not injective.
  // Conversely, let two points of the surface have the same image. If no border edges touch, one of the two is not on
  // the border, and has a neighbourhood that covers one of the image. Triangles at the other point cover a part of that
  // again, around which the border winds twice.
  //
  // This holds for any number of borders and components, and whether or not vertices are manifold. On a connected
  // surface, it means that one border turns left and all others turn right: the winding numbers are not negative, and
  // so the holes are within the outer border and apart. That does not follow from borders that are simple and apart:
  // two sheets glued crosswise along a cut have two that turn left.
  bool is_injective() const
  {
    return polygons.empty() && flipped_triangles(vertex, points).empty() && bounds_region(border, points);
  }

  std::vector<face_descriptor> face_descriptors; // of each triangle
  std::vector<std::pair<std::size_t, face_descriptor>>
      polygons; // other faces, each with the number of triangles before it
  std::vector<halfedge_descriptor> border_halfedges; // of each border edge
  std::vector<Point_2> points;                       // of each vertex
  std::vector<int> vertex;                           // of each corner: the target of a halfedge
  std::vector<Border_edge> border;

private:
  // Numbers the corners of triangles, and behind them those of polygons. Returns how many there are.
  template <typename CornerMap>
  std::size_t number_corners(CornerMap corner) const
  {
    int count = 0;
    for(halfedge_descriptor h : m_halfedges)
      put(corner, h, count++);
    for(const auto& polygon : polygons)
      for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(polygon.second, m_mesh), m_mesh))
        put(corner, h, count++);
    return static_cast<std::size_t>(count);
  }

  // In the order of their first corners
  void number_vertices()
  {
    vertex.reserve(m_halfedges.size());
    int count = 0;
    if constexpr(Corner_coordinates<TriangleMesh, UVMap>::are_at_vertices) {
      const auto number = get(CGAL::dynamic_vertex_property_t<int>(), m_mesh);
      for(const auto v : vertices(m_mesh))
        put(number, v, -1);
      for(halfedge_descriptor h : m_halfedges) {
        const auto v = target(h, m_mesh);
        int i = get(number, v);
        if(i < 0)
          put(number, v, i = count++);
        vertex.push_back(i);
      }
    } else {
      const auto corner = get(CGAL::dynamic_halfedge_property_t<int>(), m_mesh);
      const std::size_t number_of_corners = number_corners(corner);
      Disjoint_sets fans(number_of_corners); // of corners between two borders, or around a vertex of the mesh
      const auto join = [&](halfedge_descriptor h) {
        if(!m_coordinates.is_at_border(h)) // the halfedge before the opposite one has the same target
          fans.union_set(get(corner, h), get(corner, prev(opposite(h, m_mesh), m_mesh)));
      };
      for(halfedge_descriptor h : m_halfedges)
        join(h);
      for(const auto& polygon : polygons)
        for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(polygon.second, m_mesh), m_mesh))
          join(h);
      std::vector<int> number(number_of_corners, -1);
      for(std::size_t c = 0; c < m_halfedges.size(); ++c) {
        int& v = number[fans.find_set(c)];
        v = v < 0 ? count++ : v;
        vertex.push_back(v);
      }
    }
  }

  const TriangleMesh& m_mesh;
  const Corner_coordinates<TriangleMesh, UVMap> m_coordinates;
  std::vector<halfedge_descriptor> m_halfedges; // of each corner
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H
