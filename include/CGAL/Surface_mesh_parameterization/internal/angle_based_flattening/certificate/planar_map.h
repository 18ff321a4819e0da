// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_crossings.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <limits>
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

  bool is_injective() const
  {
    return is_locally_injective() && !Border_sweep<Point_2>(border, points).finds_touching_edges() &&
           !has_component_within_another();
  }

  std::vector<face_descriptor> face_descriptors;     // of each triangle
  std::vector<halfedge_descriptor> border_halfedges; // of each border edge
  std::vector<Point_2> points;                       // of each vertex
  std::vector<int> vertex;                           // of each corner
  std::vector<Border_edge> border;

private:
  // Of each vertex: a vertex of its component, the same for all.
  std::vector<int> components() const
  {
    std::vector<int> rank(points.size()), component(points.size());
    boost::disjoint_sets<int*, int*> sets(rank.data(), component.data());
    for(std::size_t v = 0; v < points.size(); ++v)
      sets.make_set(static_cast<int>(v));
    for(std::size_t c = 0; c < vertex.size(); c += 3) {
      sets.union_set(vertex[c], vertex[c + 1]);
      sets.union_set(vertex[c], vertex[c + 2]);
    }
    for(std::size_t v = 0; v < points.size(); ++v)
      component[v] = sets.find_set(static_cast<int>(v));
    return component;
  }

  // Of the vertices of each component the rightmost one.
  std::vector<int> rightmost_vertices(const std::vector<int>& component) const
  {
    std::vector<int> rightmost(points.size(), -1), result;
    for(std::size_t v = 0; v < points.size(); ++v) {
      int& best = rightmost[component[v]];
      if(best < 0 || CGAL::compare_x(points[best], points[v]) == CGAL::SMALLER)
        best = static_cast<int>(v);
    }
    for(int v : rightmost)
      if(v >= 0)
        result.push_back(v);
    return result;
  }

  // How often an edge crosses the ray that goes from `p` to the right: once or not at all, with the sign of a turn.
  int crossing(const Border_edge& edge, const Point_2& p) const
  {
    const Point_2 &q = points[edge.source], &r = points[edge.target];
    const bool starts_below = CGAL::compare_y(q, p) != CGAL::LARGER;
    const bool ends_below = CGAL::compare_y(r, p) != CGAL::LARGER;
    if(starts_below && !ends_below)
      return CGAL::orientation(q, r, p) == CGAL::LEFT_TURN ? 1 : 0;
    if(!starts_below && ends_below)
      return CGAL::orientation(q, r, p) == CGAL::RIGHT_TURN ? -1 : 0;
    return 0;
  }

  // For components that are injective each, and whose borders do not touch: then they are apart unless one contains
  // all others that it meets. A ray to the right of each is enough to see how often the others wind around it.
  bool has_component_within_another() const
  {
    const std::vector<int> component = components(), rightmost = rightmost_vertices(component);
    if(rightmost.size() < 2)
      return false;
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<Indexed_box> rays, edges = edge_boxes(border, points);
    for(std::size_t i = 0; i < rightmost.size(); ++i) {
      const CGAL::Bbox_2 box = points[rightmost[i]].bbox();
      rays.emplace_back(CGAL::Bbox_2(box.xmin(), box.ymin(), infinity, box.ymax()), static_cast<int>(i));
    }
    std::vector<int> winding(rightmost.size(), 0);
    CGAL::box_intersection_d(rays.begin(), rays.end(), edges.begin(), edges.end(),
                             [&](const Indexed_box& ray, const Indexed_box& box) {
                               const Border_edge& edge = border[box.info()];
                               const int v = rightmost[ray.info()];
                               if(component[edge.source] != component[v])
                                 winding[ray.info()] += crossing(edge, points[v]);
                             });
    for(int number : winding)
      if(number != 0)
        return true;
    return false;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_PLANAR_MAP_H
