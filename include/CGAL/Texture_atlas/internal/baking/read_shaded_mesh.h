// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads points, normals and triangles of any mesh into arrays, and names the first defect that makes baking impossible.
// `bake_mesh.h` reads the simple and the fine mesh with it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_READ_SHADED_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_READ_SHADED_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/baking/shaded_surfaces.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Reads the points, normals and triangles of a mesh, and says what is wrong with them. `vertex_normal_map` is the only
// parameter that is used beside the points.
template <typename TriangleMesh, typename NamedParameters>
class Shaded_mesh_reader
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;

public:
  typedef Mesh_report<TriangleMesh, Baking_report> Report;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  Shaded_mesh_reader(const TriangleMesh& mesh, const NamedParameters& np)
      : m_mesh(mesh), m_np(np),
        m_points(parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                              get_const_property_map(CGAL::vertex_point, mesh))),
        m_number(get(CGAL::dynamic_vertex_property_t<int>(), mesh))
  {}

  const std::vector<face_descriptor>& faces_read() const { return m_faces; }
  const std::vector<vertex_descriptor>& vertices_read() const { return m_vertices; }

  // The halfedge to corner k of a face
  halfedge_descriptor halfedge_to(face_descriptor f, int k) const
  {
    halfedge_descriptor h = halfedge(f, m_mesh);
    for(; k > 0; --k)
      h = next(h, m_mesh);
    return h;
  }

  std::string face_text(face_descriptor f) const
  {
    return internal::face_text(f, m_mesh, m_points, vertex_numbers(m_mesh, m_np));
  }

  // Reads the faces with `is_read(f)`. A point that is not finite is not looked for.
  template <typename IsRead>
  bool read(const IsRead& is_read, Shaded_surface& surface, Diagnosis not_triangulated, Report& report)
  {
    for(const vertex_descriptor v : vertices(m_mesh))
      put(m_number, v, -1);
    for(const face_descriptor f : faces(m_mesh)) {
      if(!is_read(f))
        continue;
      if(halfedge_to(f, 3) != halfedge_to(f, 0))
        return fail_at(f, report, not_triangulated, " is not a triangle");
      if(m_faces.size() == static_cast<std::size_t>(largest_number_of_triangles))
        return fail(report, Diagnosis::TOO_LARGE, "a surface has more triangles than 32-bit numbers allow");
      m_faces.push_back(f);
      for(int k = 0; k < 3; ++k)
        surface.vertex.push_back(number_of(target(halfedge_to(f, k), m_mesh), surface));
    }
    return read_normals(surface, report);
  }

  bool fail_at(face_descriptor f, Report& report, Diagnosis diagnosis, const std::string& message) const
  {
    report.offending_faces = {f};
    return fail(report, diagnosis, face_text(f) + message);
  }

  bool fail_at(vertex_descriptor v, Report& report, Diagnosis diagnosis, const std::string& message) const
  {
    report.offending_vertices = {v};
    return fail(report, diagnosis, vertex_text(vertex_numbers(m_mesh, m_np)(v), get(m_points, v)) + message);
  }

  static bool fail(Report& report, Diagnosis diagnosis, const std::string& message)
  {
    report.status = diagnosis;
    report.message = message;
    return false;
  }

private:
  template <typename Point>
  static Space_vector vector_of(const Point& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  int number_of(vertex_descriptor v, Shaded_surface& surface)
  {
    int number = get(m_number, v);
    if(number < 0) {
      number = static_cast<int>(m_vertices.size());
      put(m_number, v, number);
      m_vertices.push_back(v);
      surface.points.push_back(vector_of(get(m_points, v)));
    }
    return number;
  }

  bool read_normals(Shaded_surface& surface, Report& report) const
  {
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::vertex_normal_map_t>::value) {
      (void)surface;
      (void)report;
    } else {
      const auto normals = parameters::get_parameter(m_np, internal_np::vertex_normal_map);
      for(const vertex_descriptor v : m_vertices) {
        const Space_vector normal = vector_of(get(normals, v));
        if(!normal.allFinite() || normal.isZero(0))
          return fail_at(v, report, Diagnosis::WRONG_NORMAL, " has a normal that is zero or not finite");
        surface.normals.push_back(normal.stableNormalized());
      }
    }
    return true;
  }

  const TriangleMesh& m_mesh;
  const NamedParameters& m_np;
  Vertex_point_map m_points;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_vertex_property_t<int>>::const_type m_number;
  std::vector<face_descriptor> m_faces;
  std::vector<vertex_descriptor> m_vertices;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_READ_SHADED_MESH_H
