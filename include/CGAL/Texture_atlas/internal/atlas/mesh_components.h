// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The components of a mesh, opened along seams, and which of them are no triangulated surfaces in space, so that they
// are left out and reported; and coordinates of faces without area, which are in no chart, on an edge of a neighbor.
// `mesh_in_atlas.h` asks for both.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MESH_COMPONENTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MESH_COMPONENTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/internal/atlas/far_points.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/number_utils.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

template <typename TriangleMesh, typename VertexPointMap>
class Mesh_components
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

  struct Component
  {
    std::size_t first_face = 0; // its position in the sequence of faces
    std::size_t number_of_faces = 0;
    Diagnosis status = Diagnosis::NOTHING_WRONG; // or what is wrong with one of its faces
    std::string message;
    std::vector<face_descriptor> faces;      // of a wrong component
    std::vector<vertex_descriptor> vertices; // that are wrong
  };

public:
  Mesh_components(const TriangleMesh& mesh, VertexPointMap points, Vertex_numbers<TriangleMesh> numbers)
      : m_mesh(mesh), m_points(points), m_vertex_number(std::move(numbers))
  {}

  // Sets the number that messages call a face by, in place of its position.
  void set_numbers(std::function<std::ptrdiff_t(face_descriptor)> number) { m_number = std::move(number); }

  // Opened along the edges with `is_cut(e)`, and around wrong faces, which condemn no others but those of the same
  // polygon, across edges with `is_in_polygon(e)`
  template <typename IsCut, typename IsInPolygon>
  void find(const IsCut& is_cut, const IsInPolygon& is_in_polygon)
  {
    m_component = get(CGAL::dynamic_face_property_t<std::size_t>(), m_mesh);
    m_rank = get(CGAL::dynamic_face_property_t<std::size_t>(), m_mesh);
    m_defect = get(CGAL::dynamic_face_property_t<Diagnosis>(), m_mesh);
    std::vector<Far_points::Point> corners;
    for(face_descriptor f : faces(m_mesh))
      for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
        corners.push_back(point(target(h, m_mesh)));
    m_far_points = Far_points(std::move(corners));
    for(face_descriptor f : faces(m_mesh))
      put(m_defect, f, defect(f));
    condemn_polygons(is_in_polygon);
    const auto is_open = [&](edge_descriptor e) { return is_cut(e) || is_at_defect(e); };
    m_components.resize(Polygon_mesh_processing::connected_components(
        m_mesh, m_component,
        parameters::edge_is_constrained_map(boost::make_function_property_map<edge_descriptor>(is_open))));
    std::size_t rank = 0;
    for(face_descriptor f : faces(m_mesh)) {
      put(m_rank, f, rank);
      Component& component = m_components[get(m_component, f)];
      if(component.number_of_faces++ == 0) {
        component.first_face = rank;
        component.status = get(m_defect, f);
      }
      if(is_wrong(component))
        component.faces.push_back(f);
      if(component.status == Diagnosis::NO_AREA)
        m_without_area.push_back(f);
      ++rank;
    }
    for(Component& component : m_components)
      if(is_wrong(component)) {
        component.vertices = wrong_vertices(component);
        component.message = message(component);
      }
  }

  // Whether the faces of an edge differ in what is wrong with them
  bool is_at_defect(edge_descriptor e) const
  {
    const halfedge_descriptor h = halfedge(e, m_mesh);
    return !CGAL::is_border(e, m_mesh) &&
           get(m_defect, face(h, m_mesh)) != get(m_defect, face(opposite(h, m_mesh), m_mesh));
  }

  bool has_defects() const { return std::any_of(m_components.begin(), m_components.end(), is_wrong); }

  // Whether one of the two faces of an edge is wrong
  bool is_beside_defect(edge_descriptor e) const
  {
    const halfedge_descriptor h = halfedge(e, m_mesh);
    return get(m_defect, face(h, m_mesh)) != Diagnosis::NOTHING_WRONG ||
           get(m_defect, face(opposite(h, m_mesh), m_mesh)) != Diagnosis::NOTHING_WRONG;
  }

  const std::vector<face_descriptor>& faces_without_area() const { return m_without_area; }

  std::size_t number() const { return m_components.size(); }

  bool are_all_bad() const { return std::all_of(m_components.begin(), m_components.end(), is_wrong); }
  bool is_bad(face_descriptor f) const { return is_wrong(m_components[get(m_component, f)]); }

  std::vector<Component> bad_components() const
  {
    std::vector<Component> bad;
    std::copy_if(m_components.begin(), m_components.end(), std::back_inserter(bad), is_wrong);
    return bad;
  }

  // The position in the sequence of faces
  std::size_t rank(face_descriptor f) const { return get(m_rank, f); }

  // In messages
  std::string face_name(face_descriptor f) const { return "face " + std::to_string(number_of(f)); }

private:
  static bool is_wrong(const Component& component) { return component.status != Diagnosis::NOTHING_WRONG; }

  // Those for which faces are wrong, in the order of the faces
  std::vector<vertex_descriptor> wrong_vertices(const Component& component) const
  {
    std::vector<vertex_descriptor> result;
    std::set<vertex_descriptor> found;
    for(face_descriptor f : component.faces)
      for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
        const vertex_descriptor v = target(h, m_mesh);
        if(defect(point(v)) == component.status && found.insert(v).second)
          result.push_back(v);
      }
    return result;
  }

  // All triangles of a polygon with a wrong vertex are wrong, as its first one is.
  template <typename IsInPolygon>
  void condemn_polygons(const IsInPolygon& is_in_polygon)
  {
    std::set<face_descriptor> found;
    for(face_descriptor first : faces(m_mesh)) {
      const Diagnosis wrong = get(m_defect, first);
      if((wrong != Diagnosis::NON_FINITE_POINT && wrong != Diagnosis::FAR_POINT) ||
         !found.insert(first).second)
        continue;
      for(std::vector<face_descriptor> stack = {first}; !stack.empty();) {
        const face_descriptor f = stack.back();
        stack.pop_back();
        put(m_defect, f, wrong);
        for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
          if(is_in_polygon(edge(h, m_mesh)) && found.insert(face(opposite(h, m_mesh), m_mesh)).second)
            stack.push_back(face(opposite(h, m_mesh), m_mesh));
      }
    }
  }

  Far_points::Point point(vertex_descriptor v) const
  {
    const auto& p = get(m_points, v);
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  Diagnosis defect(const Far_points::Point& p) const
  {
    return !Far_points::is_finite(p) ? Diagnosis::NON_FINITE_POINT
           : m_far_points.contain(p) ? Diagnosis::FAR_POINT
                                     : Diagnosis::NOTHING_WRONG;
  }

  Diagnosis defect(face_descriptor f) const
  {
    for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh))
      if(const Diagnosis wrong = defect(point(target(h, m_mesh))); wrong != Diagnosis::NOTHING_WRONG)
        return wrong;
    if(!CGAL::is_triangle(halfedge(f, m_mesh), m_mesh))
      return Diagnosis::UNDIVIDED_FACE;
    return has_no_area(f) ? Diagnosis::NO_AREA : Diagnosis::NOTHING_WRONG;
  }

  // Whether the corners of a triangle are exactly on one line
  bool has_no_area(face_descriptor f) const
  {
    Exact_predicates_inexact_constructions_kernel::Point_3 points[3];
    halfedge_descriptor h = halfedge(f, m_mesh);
    for(auto& corner : points) {
      const auto [x, y, z] = point(target(h, m_mesh));
      corner = {x, y, z};
      h = next(h, m_mesh);
    }
    return CGAL::collinear(points[0], points[1], points[2]);
  }

  std::ptrdiff_t number_of(face_descriptor f) const
  {
    return m_number ? m_number(f) : static_cast<std::ptrdiff_t>(rank(f));
  }

  std::string vertex_name(vertex_descriptor v) const
  {
    return vertex_text(m_vertex_number(v), get(m_points, v));
  }

  std::string message(const Component& component) const
  {
    const face_descriptor f = *std::min_element(
        component.faces.begin(), component.faces.end(),
        [this](face_descriptor g, face_descriptor k) { return number_of(g) < number_of(k); });
    const std::string face = face_name(f);
    if(component.vertices.empty())
      return face + ", at " + vertex_name(target(halfedge(f, m_mesh), m_mesh)) + ", " +
             (component.status == Diagnosis::UNDIVIDED_FACE
                  ? "cannot be divided into triangles: other edges join its corners already"
                  : "has no area, and no neighbor with a chart");
    return wrong_points_text(vertex_name(component.vertices.front()), component.vertices.size(),
                             component.status) +
           ", first in " + face;
  }

  const TriangleMesh& m_mesh;
  VertexPointMap m_points;
  Vertex_numbers<TriangleMesh> m_vertex_number; // in messages
  typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<std::size_t>>::const_type
      m_component,
      m_rank; // of each face
  typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<Diagnosis>>::const_type m_defect;
  std::function<std::ptrdiff_t(face_descriptor)> m_number; // or null
  Far_points m_far_points;
  std::vector<face_descriptor> m_without_area;
  std::vector<Component> m_components;
};

// Where a corner of a face is
struct Corner_in_atlas
{
  Chart::Point_2 uv;
  std::size_t chart;
};

template <typename TriangleMesh, typename VertexPointMap>
class Faces_without_area
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

public:
  Faces_without_area(const TriangleMesh& mesh, VertexPointMap points) : m_mesh(mesh), m_points(points) {}

  // `corner_at(h)` is the corner that a halfedge of a face points to, if the face is in a chart. A neighbor may be
  // another face without area, which was placed before.
  template <typename CornerAt>
  void place(std::vector<face_descriptor> faces, const CornerAt& corner_at)
  {
    for(std::size_t before = faces.size() + 1; faces.size() < before;) {
      before = faces.size();
      const auto is_placed = [&](face_descriptor f) { return place_face(f, corner_at); };
      faces.erase(std::remove_if(faces.begin(), faces.end(), is_placed), faces.end());
    }
  }

  // The charts of faces that were placed, and the coordinates of their halfedges' targets
  const std::map<face_descriptor, std::size_t>& charts() const { return m_charts; }
  const std::map<halfedge_descriptor, Chart::Point_2>& uv() const { return m_uv; }

private:
  // On its longest edge with such a neighbor: each corner is at the nearer end, which any number type can hold.
  // Returns whether there is one.
  template <typename CornerAt>
  bool place_face(face_descriptor f, const CornerAt& corner_at)
  {
    double length = -1;
    std::optional<Corner_in_atlas> from, to;
    halfedge_descriptor longest;
    for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
      const halfedge_descriptor across = opposite(h, m_mesh); // which runs the other way
      const double squared = squared_distance(source(h, m_mesh), target(h, m_mesh));
      if(CGAL::is_border(across, m_mesh) || !(squared > length))
        continue;
      if(const std::optional<Corner_in_atlas> corner = corner_of(across, corner_at)) {
        length = squared;
        longest = h;
        from = corner;
        to = corner_of(prev(across, m_mesh), corner_at);
      }
    }
    if(!from)
      return false;
    const vertex_descriptor third = target(next(longest, m_mesh), m_mesh);
    m_uv[longest] = to->uv;
    m_uv[prev(longest, m_mesh)] = from->uv;
    m_uv[next(longest, m_mesh)] =
        squared_distance(third, source(longest, m_mesh)) < squared_distance(third, target(longest, m_mesh))
            ? from->uv
            : to->uv;
    m_charts[f] = from->chart;
    return true;
  }

  template <typename CornerAt>
  std::optional<Corner_in_atlas> corner_of(halfedge_descriptor h, const CornerAt& corner_at) const
  {
    const auto uv = m_uv.find(h);
    return uv == m_uv.end() ? corner_at(h) : Corner_in_atlas{uv->second, m_charts.at(face(h, m_mesh))};
  }

  double squared_distance(vertex_descriptor v, vertex_descriptor w) const
  {
    return CGAL::to_double(CGAL::squared_distance(get(m_points, v), get(m_points, w)));
  }

  const TriangleMesh& m_mesh;
  VertexPointMap m_points;
  std::map<face_descriptor, std::size_t> m_charts;
  std::map<halfedge_descriptor, Chart::Point_2> m_uv;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MESH_COMPONENTS_H
