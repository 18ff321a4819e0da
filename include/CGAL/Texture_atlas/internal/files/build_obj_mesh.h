// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_FILES_BUILD_OBJ_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_FILES_BUILD_OBJ_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Texture_atlas/internal/files/read_obj_soup.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/Kernel_traits.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Finds what keeps faces from being a mesh of halfedges. `is_polygon_soup_a_polygon_mesh()` of CGAL names no face, and
// refuses vertices of several fans on borders, which meshes can have.
class Obj_soup_check
{
  struct Edge
  {
    std::size_t from, to, corner; // where it begins

    std::pair<std::size_t, std::size_t> ends() const { return {from, to}; }
  };

public:
  explicit Obj_soup_check(const Obj_soup& soup) : m_soup(soup) {}

  OBJ_report run()
  {
    if(const std::size_t c = repeated_corner(); c != Obj_soup::none)
      return failure(Diagnosis::REPEATED_VERTEX, c, " names " + vertex_name(c) + " twice");
    list_edges();
    if(const std::size_t e = repeated_edge(); e != Obj_soup::none)
      return edge_failure(m_edges[e - 1].corner, m_edges[e].corner);
    if(const std::size_t c = pinched_corner(); c != Obj_soup::none)
      return failure(Diagnosis::NON_MANIFOLD_VERTEX, c,
                     " has " + vertex_name(c) +
                         ", which is surrounded by faces and belongs to others as well");
    return OBJ_report();
  }

private:
  std::size_t repeated_corner() const
  {
    std::vector<std::size_t> corner_of(m_soup.points.size(), Obj_soup::none); // the last one so far
    for(std::size_t f = 0; f < m_soup.number_of_faces(); ++f)
      for(std::size_t c = m_soup.first_corners[f]; c < m_soup.first_corners[f + 1]; ++c) {
        std::size_t& last = corner_of[m_soup.vertices[c]];
        if(last != Obj_soup::none && last >= m_soup.first_corners[f])
          return c;
        last = c;
      }
    return Obj_soup::none;
  }

  void list_edges()
  {
    for(std::size_t f = 0; f < m_soup.number_of_faces(); ++f)
      for(std::size_t c = m_soup.first_corners[f]; c < m_soup.first_corners[f + 1]; ++c) {
        const std::size_t next = c + 1 < m_soup.first_corners[f + 1] ? c + 1 : m_soup.first_corners[f];
        m_edges.push_back({m_soup.vertices[c], m_soup.vertices[next], c});
      }
    std::sort(m_edges.begin(), m_edges.end(), [](const Edge& a, const Edge& b) {
      return std::make_pair(a.ends(), a.corner) < std::make_pair(b.ends(), b.corner);
    });
  }

  // Of those that come after an equal one, that of the first corner
  std::size_t repeated_edge() const
  {
    std::size_t found = Obj_soup::none;
    for(std::size_t e = 1; e < m_edges.size(); ++e)
      if(m_edges[e - 1].ends() == m_edges[e].ends() &&
         (found == Obj_soup::none || m_edges[e].corner < m_edges[found].corner))
        found = e;
    return found;
  }

  // A corner in one of several fans at a vertex, if one of these is closed
  std::size_t pinched_corner() const
  {
    Disjoint_sets fans(m_soup.vertices.size());
    std::vector<std::size_t> ends; // corners where a fan ends
    for(const Edge& edge : m_edges) {
      const std::pair<std::size_t, std::size_t> opposite(edge.to, edge.from);
      const auto other =
          std::lower_bound(m_edges.begin(), m_edges.end(), opposite,
                           [](const Edge& e, const auto& wanted) { return e.ends() < wanted; });
      if(other != m_edges.end() && other->ends() == opposite)
        fans.union_set(edge.corner, m_soup.next(other->corner));
      else
        ends.push_back(edge.corner);
    }
    std::vector<bool> is_open(m_soup.vertices.size(), false);
    for(const std::size_t c : ends)
      is_open[fans.find_set(c)] = true;
    std::vector<std::size_t> first_fan(m_soup.points.size(), Obj_soup::none);
    for(std::size_t c = 0; c < m_soup.vertices.size(); ++c) {
      const std::size_t fan = fans.find_set(c);
      std::size_t& first = first_fan[m_soup.vertices[c]];
      if(first == Obj_soup::none)
        first = fan;
      else if(first != fan && !(is_open[first] && is_open[fan]))
        return c;
    }
    return Obj_soup::none;
  }

  std::string vertex_name(std::size_t corner) const
  {
    return "vertex " + std::to_string(m_soup.vertices[corner] + 1);
  }

  OBJ_report edge_failure(std::size_t before, std::size_t corner) const
  {
    return failure(Diagnosis::NON_MANIFOLD_EDGE, corner,
                   " has the edge from " + vertex_name(corner) + " to " + vertex_name(m_soup.next(corner)) +
                       " in the same direction as face " + std::to_string(m_soup.face(before) + 1));
  }

  OBJ_report failure(Diagnosis status, std::size_t corner, const std::string& what) const
  {
    const std::size_t f = m_soup.face(corner);
    return obj_failure(status, "face " + std::to_string(f + 1) + what, m_soup.lines[f]);
  }

  const Obj_soup& m_soup;
  std::vector<Edge> m_edges; // of all faces, sorted by their ends
};

// Finds a corner with other texture coordinates than one before it at the same vertex.
inline OBJ_report check_vertex_coordinates(const Obj_soup& soup)
{
  std::vector<std::size_t> first(soup.points.size(), Obj_soup::none);
  for(std::size_t c = 0; c < soup.vertices.size(); ++c) {
    if(soup.corner_coordinates[c] == Obj_soup::none)
      continue;
    std::size_t& before = first[soup.vertices[c]];
    if(before == Obj_soup::none)
      before = soup.corner_coordinates[c];
    else if(soup.coordinates[before] != soup.coordinates[soup.corner_coordinates[c]]) {
      const std::size_t f = soup.face(c);
      return obj_failure(Diagnosis::INCONSISTENT_COORDINATES,
                         "vertex " + std::to_string(soup.vertices[c] + 1) +
                             " has other coordinates in face " + std::to_string(f + 1) +
                             " than before: read coordinates of halfedges",
                         soup.lines[f]);
    }
  }
  return OBJ_report();
}

// Adds the vertices and faces of an OBJ file to a mesh, if they fit together.
template <typename PolygonMesh, typename UVMap, typename VertexPointMap>
class Obj_mesh_builder
{
  typedef boost::graph_traits<PolygonMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::value_type Point_3;
  typedef typename boost::property_traits<UVMap>::value_type Point_2;
  typedef typename CGAL::Kernel_traits<Point_3>::Kernel::FT FT_3;
  typedef typename CGAL::Kernel_traits<Point_2>::Kernel::FT FT_2;
  static constexpr bool has_uv_at_vertices = Corner_coordinates<PolygonMesh, UVMap>::are_at_vertices;

public:
  Obj_mesh_builder(const Obj_soup& soup, PolygonMesh& mesh, UVMap uv, VertexPointMap points)
      : m_soup(soup), m_mesh(mesh), m_uv(uv), m_points(points)
  {}

  OBJ_report run()
  {
    OBJ_report report = Obj_soup_check(m_soup).run();
    if constexpr(has_uv_at_vertices)
      if(report)
        report = check_vertex_coordinates(m_soup);
    if(report)
      report = check_range<FT_3>(m_soup.points, "vertex ");
    if(report)
      report = check_range<FT_2>(m_soup.coordinates, "texture coordinates ");
    if(!report)
      return report;
    add_vertices();
    for(std::size_t f = 0; f < m_soup.number_of_faces(); ++f)
      add_face(f);
    return report;
  }

private:
  // Numbers of type `float` may be too small.
  template <typename FT, typename Points>
  static OBJ_report check_range(const Points& points, const std::string& name)
  {
    if constexpr(std::is_floating_point<FT>::value)
      for(std::size_t i = 0; i < points.size(); ++i)
        for(const double x : points[i])
          if(std::abs(x) > (std::numeric_limits<FT>::max)())
            return obj_failure(Diagnosis::PRECISION_EXCEEDED, name + std::to_string(i + 1) +
                                                                  ": a number is too large for the type of "
                                                                  "the coordinates");
    return OBJ_report();
  }

  void add_vertices()
  {
    m_vertices.reserve(m_soup.points.size());
    for(const std::array<double, 3>& p : m_soup.points) {
      m_vertices.push_back(add_vertex(m_mesh));
      put(m_points, m_vertices.back(), Point_3(FT_3(p[0]), FT_3(p[1]), FT_3(p[2])));
    }
  }

  void add_face(std::size_t f)
  {
    const std::size_t begin = m_soup.first_corners[f], end = m_soup.first_corners[f + 1];
    std::vector<vertex_descriptor> corners;
    for(std::size_t c = begin; c < end; ++c)
      corners.push_back(m_vertices[m_soup.vertices[c]]);
    const face_descriptor face = CGAL::Euler::add_face(corners, m_mesh);
    CGAL_assertion(face != Graph_traits::null_face());
    halfedge_descriptor h = halfedge(face, m_mesh);
    while(target(h, m_mesh) != corners.front())
      h = next(h, m_mesh);
    for(std::size_t c = begin; c < end; ++c, h = next(h, m_mesh))
      if(m_soup.corner_coordinates[c] != Obj_soup::none)
        put_uv(h, m_soup.coordinates[m_soup.corner_coordinates[c]]);
  }

  void put_uv(halfedge_descriptor h, const std::array<double, 2>& p)
  {
    if constexpr(has_uv_at_vertices)
      put(m_uv, target(h, m_mesh), Point_2(FT_2(p[0]), FT_2(p[1])));
    else
      put(m_uv, h, Point_2(FT_2(p[0]), FT_2(p[1])));
  }

  const Obj_soup& m_soup;
  PolygonMesh& m_mesh;
  UVMap m_uv;
  VertexPointMap m_points;
  std::vector<vertex_descriptor> m_vertices; // of the mesh, by their numbers in the file
};

template <typename PolygonMesh, typename UVMap, typename VertexPointMap>
OBJ_report build_obj_mesh(const Obj_soup& soup, PolygonMesh& mesh, UVMap uv, VertexPointMap points)
{
  return Obj_mesh_builder<PolygonMesh, UVMap, VertexPointMap>(soup, mesh, uv, points).run();
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_FILES_BUILD_OBJ_MESH_H
