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

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <stdexcept>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Faces of a mesh, drawn in the plane: all that the certificate looks at.
template <typename TriangleMesh, typename VertexUVMap>
class Planar_map
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef Exact_point<typename boost::property_traits<VertexUVMap>::value_type> Convert;

public:
  typedef typename Convert::type Point_2;

  // `faces` must consist of connected components. Throws `std::invalid_argument` if a face is not a triangle.
  template <typename FaceRange>
  Planar_map(const TriangleMesh& mesh, const FaceRange& faces, VertexUVMap uvmap)
  {
    const auto rank = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
    for(vertex_descriptor v : vertices(mesh))
      put(rank, v, -1);
    for(face_descriptor f : faces) {
      halfedge_descriptor h = halfedge(f, mesh);
      if(next(next(next(h, mesh), mesh), mesh) != h)
        throw std::invalid_argument("a face is not a triangle");
      face_descriptors.push_back(f);
      for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
        const vertex_descriptor v = target(h, mesh);
        if(get(rank, v) < 0) {
          put(rank, v, static_cast<int>(points.size()));
          points.push_back(Convert::get(get(uvmap, v)));
        }
        vertex.push_back(get(rank, v));
        const halfedge_descriptor across = opposite(h, mesh);
        if(CGAL::is_border(across, mesh))
          border_halfedges.push_back(across);
      }
    }
    for(halfedge_descriptor h : border_halfedges)
      border.push_back({get(rank, target(h, mesh)), get(rank, source(h, mesh))});
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
  std::vector<int> vertex;                           // of each corner
  std::vector<Border_edge> border;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H
