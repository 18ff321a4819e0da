// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_FILES_BUILD_OBJ_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_FILES_BUILD_OBJ_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_map.h>
#include <CGAL/Texture_atlas/internal/files/check_obj_soup.h>
#include <CGAL/Texture_atlas/internal/files/read_obj_soup.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Texture_atlas::internal {

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
