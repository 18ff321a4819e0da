// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {

template <class TM, class SEM, class SVM>
class Seam_mesh;

} // namespace CGAL

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// What a `Seam_mesh` knows of its seams. `across()` returns the halfedge on the other side of a seam, of an inner one at the border;
// the null halfedge where there is no seam.
template <typename TriangleMesh>
struct Seam_sides
{
  typedef void surface_vertex_descriptor;
  static constexpr bool has_seams = false;
};

template <typename TM, typename SEM, typename SVM>
struct Seam_sides<CGAL::Seam_mesh<TM, SEM, SVM>>
{
  typedef CGAL::Seam_mesh<TM, SEM, SVM> Mesh;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<TM>::vertex_descriptor surface_vertex_descriptor;
  static constexpr bool has_seams = true;

  static halfedge_descriptor across(const halfedge_descriptor& h, const Mesh& mesh)
  {
    const typename Mesh::TM_halfedge_descriptor other = opposite(h.tmhd, mesh.mesh());
    return mesh.has_on_seam(h.tmhd) && !CGAL::is_border(other, mesh.mesh())
               ? halfedge_descriptor(other)
               : boost::graph_traits<Mesh>::null_halfedge();
  }

  // The vertex of the mesh that was cut
  static surface_vertex_descriptor
  surface_vertex(const typename boost::graph_traits<Mesh>::vertex_descriptor& v, const Mesh& mesh)
  {
    const typename Mesh::TM_halfedge_descriptor h = v;
    return target(h, mesh.mesh());
  }
};

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

  // Sets which corners are across a seam. `across` maps an inner halfedge at the border to that on the other side, or to the null
  // halfedge. Of a seam between two components there is no other side here.
  template <typename Across>
  void link_seams(const Across& across)
  {
    chart.seam.assign(3 * face_descriptors.size(), -1);
    for_each_corner([&](halfedge_descriptor h, int c) {
      const int facing = next_corner(c); // the one that faces `h`
      if(chart.opposite[facing] >= 0)
        return;
      const halfedge_descriptor other = across(h);
      if(other != Graph_traits::null_halfedge() && get(*m_ranks, face(other, m_mesh)) >= 0)
        chart.seam[facing] = facing_corner(other, *m_ranks);
    });
  }

  Chart chart;
  std::vector<vertex_descriptor> vertex_descriptors; // of each vertex of the chart
  std::vector<face_descriptor> face_descriptors;     // of each triangle of the chart

private:
  // Sets `face_descriptors` and the chart's corner table up to the vertices. Faces come in the order of a breadth-first
  // search, whatever that of the mesh is, so that neighbours are near to each other in memory.
  Chart_defect find_faces(halfedge_descriptor bhd)
  {
    if(bhd == Graph_traits::null_halfedge() || !CGAL::is_border(bhd, m_mesh))
      return {Flattening_report::NOT_ON_BORDER, "the given halfedge is not on a border", {}, {}};
    const halfedge_descriptor inner = opposite(bhd, m_mesh);
    if(CGAL::is_border(inner, m_mesh))
      return {Flattening_report::EMPTY_MESH, "there is no face at the given border halfedge", {}, {}};

    Face_ranks ranks = get(CGAL::dynamic_face_property_t<int>(), m_mesh);
    for(face_descriptor f : faces(m_mesh))
      put(ranks, f, -1);
    const auto find = [&](face_descriptor f) {
      if(get(ranks, f) >= 0)
        return;
      put(ranks, f, static_cast<int>(face_descriptors.size()));
      face_descriptors.push_back(f);
    };
    find(face(inner, m_mesh));
    for(std::size_t t = 0; t < face_descriptors.size(); ++t) {
      halfedge_descriptor h = halfedge(face_descriptors[t], m_mesh);
      for(int k = 0; k < 3; ++k, h = next(h, m_mesh))
        if(const halfedge_descriptor across = opposite(h, m_mesh); !CGAL::is_border(across, m_mesh))
          find(face(across, m_mesh));
      if(h != halfedge(face_descriptors[t], m_mesh))
        return {Flattening_report::NOT_TRIANGULATED, "a face is not a triangle", {}, {static_cast<int>(t)}};
      if(face_descriptors.size() > static_cast<std::size_t>(largest_number_of_triangles))
        return {
            Flattening_report::TOO_LARGE, "the surface has more triangles than 32-bit numbers allow", {}, {}};
    }
    link_corners(ranks);
    m_ranks = ranks;
    if constexpr(Seam_sides<TriangleMesh>::has_seams)
      link_seams([&](halfedge_descriptor h) { return Seam_sides<TriangleMesh>::across(h, m_mesh); });
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

  // Calls `visit` with the halfedge to the vertex of each corner, and the corner.
  template <typename Visitor>
  void for_each_corner(const Visitor& visit) const
  {
    int c = 0;
    for(face_descriptor f : face_descriptors) {
      halfedge_descriptor h = halfedge(f, m_mesh);
      for(int k = 0; k < 3; ++k, h = next(h, m_mesh))
        visit(h, c++);
    }
  }

  // Sets `vertex_descriptors`, in the order in which the faces come upon them, and the vertex of each corner.
  template <typename VertexIndexMap>
  void number_vertices(VertexIndexMap vimap)
  {
    typedef typename boost::property_traits<VertexIndexMap>::value_type Index;
    std::vector<Index> indices(3 * face_descriptors.size());
    for_each_corner([&](halfedge_descriptor h, int c) { indices[c] = get(vimap, target(h, m_mesh)); });
    make_indices_dense(indices);
    std::vector<int> ranks(static_cast<std::size_t>(*std::max_element(indices.begin(), indices.end())) + 1,
                           -1);
    chart.vertex.resize(indices.size());
    for_each_corner([&](halfedge_descriptor h, int c) {
      int& rank = ranks[static_cast<std::size_t>(indices[c])];
      if(rank < 0) {
        rank = static_cast<int>(vertex_descriptors.size());
        vertex_descriptors.push_back(target(h, m_mesh));
      }
      chart.vertex[c] = rank;
    });
  }

  // Replaces indices of vertices that are too far apart for an array.
  template <typename Index>
  static void make_indices_dense(std::vector<Index>& indices)
  {
    const auto [least, largest] = std::minmax_element(indices.begin(), indices.end());
    if(!(*least < Index(0)) && static_cast<std::size_t>(*largest) < 8 * indices.size())
      return;
    std::vector<Index> sorted = indices;
    std::sort(sorted.begin(), sorted.end());
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    for(Index& v : indices)
      v = static_cast<Index>(std::lower_bound(sorted.begin(), sorted.end(), v) - sorted.begin());
  }

  void read_points()
  {
    const auto points = get(CGAL::vertex_point, m_mesh);
    double largest = 0;
    chart.points.reserve(vertex_descriptors.size());
    for(vertex_descriptor v : vertex_descriptors) {
      const auto& p = get(points, v);
      chart.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      for(int i = 0; i < 3; ++i)
        largest = (std::max)(largest, std::abs(chart.points.back()[i]));
    }
    chart.scale = power_of_two(largest);
    for(Chart::Point_3& p : chart.points)
      p = Chart::Point_3(p.x() / chart.scale, p.y() / chart.scale, p.z() / chart.scale);
    find_borders(chart, m_first_border);
  }

  const TriangleMesh& m_mesh;
  int m_first_border = -1;
  std::optional<Face_ranks> m_ranks;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_CHART_H
