// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_READ_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_READ_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/diagnose.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Reads the connected component of a border halfedge into a chart. Any model of `FaceGraph` will do; the mesh is not
// looked at afterwards, but for writing the result.
template <typename TriangleMesh>
class Chart_reader
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef
      typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int>>::const_type Face_ranks;

public:
  Chart_reader(const TriangleMesh& mesh) : m_mesh(mesh) {}

  // `vimap` maps each vertex to an integer of its own; these need not be consecutive.
  template <typename VertexIndexMap>
  Chart_defect read(halfedge_descriptor bhd, VertexIndexMap vimap)
  {
    if(Chart_defect defect = find_faces(bhd))
      return defect;
    number_vertices(vimap);
    read_points();
    return {};
  }

  Chart_defect read(halfedge_descriptor bhd)
  {
    const auto vimap = get(CGAL::dynamic_vertex_property_t<int>(), m_mesh);
    int index = 0;
    for(vertex_descriptor v : vertices(m_mesh))
      put(vimap, v, index++);
    return read(bhd, vimap);
  }

  Chart chart;
  std::vector<vertex_descriptor> vertex_descriptors; // of each vertex of the chart
  std::vector<face_descriptor> face_descriptors;     // of each triangle of the chart

private:
  // Sets `face_descriptors`, in the order of the mesh, and the chart's corner table up to the vertices.
  Chart_defect find_faces(halfedge_descriptor bhd)
  {
    if(bhd == Graph_traits::null_halfedge() || !CGAL::is_border(bhd, m_mesh))
      return {ABF_plus_plus_report::NOT_ON_BORDER, "the given halfedge is not on a border", {}, {}};
    const halfedge_descriptor inner = opposite(bhd, m_mesh);
    if(CGAL::is_border(inner, m_mesh))
      return {ABF_plus_plus_report::EMPTY_MESH, "there is no face at the given border halfedge", {}, {}};

    std::vector<face_descriptor> component;
    Polygon_mesh_processing::connected_component(face(inner, m_mesh), m_mesh, std::back_inserter(component));
    if(component.size() > static_cast<std::size_t>((std::numeric_limits<int>::max)()) / 9)
      return {ABF_plus_plus_report::TOO_LARGE,
              "the surface has more triangles than 32-bit numbers allow",
              {},
              {}};

    Face_ranks ranks = get(CGAL::dynamic_face_property_t<int>(), m_mesh);
    for(face_descriptor f : faces(m_mesh))
      put(ranks, f, -1);
    for(face_descriptor f : component)
      put(ranks, f, 0);
    for(face_descriptor f : faces(m_mesh)) {
      if(get(ranks, f) < 0)
        continue;
      put(ranks, f, static_cast<int>(face_descriptors.size()));
      face_descriptors.push_back(f);
      if(next(next(next(halfedge(f, m_mesh), m_mesh), m_mesh), m_mesh) != halfedge(f, m_mesh))
        return {ABF_plus_plus_report::NOT_TRIANGULATED, "a face is not a triangle", {}, {0}};
    }
    link_corners(ranks);
    m_first_border = facing_corner(inner, ranks);
    return {};
  }

  // The corner of the face of `h` that faces `h`. Corner k of a face is at the target of its halfedge number k, and
  // so faces halfedge number k + 2.
  int facing_corner(halfedge_descriptor h, const Face_ranks& ranks) const
  {
    const face_descriptor f = face(h, m_mesh);
    int k = 1;
    for(halfedge_descriptor g = halfedge(f, m_mesh); g != h; g = next(g, m_mesh))
      ++k;
    return 3 * get(ranks, f) + k % 3;
  }

  void link_corners(const Face_ranks& ranks)
  {
    chart.opposite.resize(3 * face_descriptors.size());
    for(std::size_t t = 0; t < face_descriptors.size(); ++t) {
      halfedge_descriptor h = halfedge(face_descriptors[t], m_mesh);
      for(int k : {1, 2, 0}) {
        const halfedge_descriptor across = opposite(h, m_mesh);
        chart.opposite[3 * t + k] = CGAL::is_border(across, m_mesh) ? -1 : facing_corner(across, ranks);
        h = next(h, m_mesh);
      }
    }
  }

  // Sets `vertex_descriptors`, in the order of `vimap`, and the vertex of each corner.
  template <typename VertexIndexMap>
  void number_vertices(VertexIndexMap vimap)
  {
    std::vector<vertex_descriptor> of_corner;
    of_corner.reserve(3 * face_descriptors.size());
    for(face_descriptor f : face_descriptors) {
      halfedge_descriptor h = halfedge(f, m_mesh);
      for(int k = 0; k < 3; ++k, h = next(h, m_mesh)) {
        of_corner.push_back(target(h, m_mesh));
        chart.vertex.push_back(static_cast<int>(get(vimap, of_corner.back())));
      }
    }
    std::vector<int> indices = chart.vertex;
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    vertex_descriptors.resize(indices.size());
    for(std::size_t c = 0; c < of_corner.size(); ++c) {
      const auto rank = std::lower_bound(indices.begin(), indices.end(), chart.vertex[c]) - indices.begin();
      chart.vertex[c] = static_cast<int>(rank);
      vertex_descriptors[rank] = of_corner[c];
    }
  }

  void read_points()
  {
    const auto points = get(CGAL::vertex_point, m_mesh);
    for(vertex_descriptor v : vertex_descriptors) {
      const auto& p = get(points, v);
      chart.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    }
    find_borders(chart, m_first_border);
  }

  const TriangleMesh& m_mesh;
  int m_first_border = -1;
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_READ_CHART_H
