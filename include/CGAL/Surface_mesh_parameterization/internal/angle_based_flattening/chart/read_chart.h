// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Copies the connected component of a border halfedge from the caller's mesh into a chart, and links the sides of
// seams. The first stage of every parameterizer (`run_parameterizer.h`), and of `measure_flattening.h`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/face_search.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/seam_sides.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The points of the vertices of a mesh. It hides the type of the caller's property map.
template <typename TriangleMesh>
using Vertex_points = std::function<Chart::Point_3(
    const typename boost::graph_traits<TriangleMesh>::vertex_descriptor&, const TriangleMesh&)>;

// The keys are vertices of the mesh, or of a seam mesh also those of the mesh below it.
template <typename TriangleMesh, typename VertexPointMap>
Vertex_points<TriangleMesh> vertex_points(VertexPointMap map)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::property_traits<VertexPointMap>::key_type Key;
  if constexpr(std::is_same_v<Key, typename Seam_sides<TriangleMesh>::surface_vertex_descriptor>)
    return [map](const vertex_descriptor& v, const TriangleMesh& mesh) {
      return point_in_doubles(get(map, Seam_sides<TriangleMesh>::surface_vertex(v, mesh)));
    };
  else
    return [map](const vertex_descriptor& v, const TriangleMesh&) { return point_in_doubles(get(map, v)); };
}

// Those that named parameters give; empty if they give none
template <typename TriangleMesh, typename NamedParameters>
Vertex_points<TriangleMesh> given_points(const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value) {
    (void)np;
    return {};
  } else
    return vertex_points<TriangleMesh>(parameters::get_parameter(np, internal_np::vertex_point));
}

// Ranks by integers of the caller's, which need not be consecutive: those in [0, limit) are in an array, all others in
// a hash table.
template <typename Index>
class Vertex_ranks
{
public:
  explicit Vertex_ranks(std::size_t limit) : m_limit(limit) {}

  // The rank of an index, -1 if it has not been set; valid until the next call
  int& operator[](const Index& index)
  {
    if(index < Index(0) || !(static_cast<std::size_t>(index) < m_limit))
      return m_others.emplace(index, -1).first->second;
    const std::size_t i = static_cast<std::size_t>(index);
    if(i >= m_ranks.size())
      m_ranks.resize((std::min)((std::max)(i + 1, 2 * m_ranks.size()), m_limit), -1);
    return m_ranks[i];
  }

private:
  std::size_t m_limit;
  std::vector<int> m_ranks;
  std::unordered_map<Index, int> m_others;
};

// Reads the connected component of a border halfedge into a chart. Any model of `FaceGraph` will do; the mesh is not
// looked at afterwards, but for writing the result and naming faces.
template <typename TriangleMesh>
class Chart_reader
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

public:
  // Without `points`, they are those of the mesh; without `numbers`, messages number vertices by positions.
  explicit Chart_reader(const TriangleMesh& mesh, Vertex_points<TriangleMesh> points = {},
                        Vertex_numbers<TriangleMesh> numbers = {})
      : m_mesh(mesh), m_points(std::move(points)), m_numbers(std::move(numbers)), m_faces(mesh)
  {}

  // `vimap` maps each vertex to an integer of its own; these need not be consecutive.
  template <typename VertexIndexMap>
  Chart_defect read(halfedge_descriptor bhd, VertexIndexMap vimap)
  {
    if(Chart_defect defect = find_no_border(bhd))
      return defect;
    const halfedge_descriptor inner = opposite(bhd, m_mesh);
    if(CGAL::is_border(inner, m_mesh))
      return {Diagnosis::EMPTY_MESH, "there is no face at the given border halfedge", {}, {}};
    if(Chart_defect defect = find_faces(inner, vimap))
      return defect;
    if constexpr(Seam_sides<TriangleMesh>::has_seams)
      link_seams([&](halfedge_descriptor h) { return Seam_sides<TriangleMesh>::across(h, m_mesh); });
    read_points();
    find_borders(chart, 1); // which faces the border
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

  // Returns memory that is needed only to read, after all seams are linked.
  void end() { m_faces.forget_ranks(); }

  // Sets which corners are across a seam. `across` maps an inner halfedge at the border to that on the other side, or
  // to the null halfedge. A seam between two components has no other side here.
  template <typename Across>
  void link_seams(const Across& across)
  {
    chart.seam.assign(chart.opposite.size(), -1);
    for(int c = 0; c < static_cast<int>(chart.opposite.size()); ++c)
      if(chart.opposite[c] < 0) {
        const halfedge_descriptor other = across(m_faces.faced_halfedge(c));
        if(other == Graph_traits::null_halfedge())
          continue;
        if(const int t = m_faces.rank(face(other, m_mesh)); t >= 0)
          chart.seam[c] = 3 * t + m_faces.facing_corner(other, t);
      }
  }

  int number_of_faces() const { return m_faces.size(); }
  face_descriptor face_of_triangle(int t) const { return m_faces.face_of(t); }

  Chart chart;
  std::vector<vertex_descriptor> vertex_descriptors; // of each vertex of the chart

private:
  // A closed surface is named before a halfedge that is wrong for that reason.
  Chart_defect find_no_border(halfedge_descriptor bhd) const
  {
    const bool is_null = bhd == Graph_traits::null_halfedge();
    if(!is_null && CGAL::is_border(bhd, m_mesh))
      return {};
    const auto all = halfedges(m_mesh);
    if(all.begin() == all.end())
      return {Diagnosis::EMPTY_MESH, "the mesh has no faces", {}, {}};
    if(std::none_of(all.begin(), all.end(), [this](const auto& h) { return CGAL::is_border(h, m_mesh); }))
      return {Diagnosis::NO_BORDER,
              "the surface is closed: it has no border; make_atlas() takes it as it is, and select_seams() "
              "chooses "
              "where to cut it open",
              {},
              {}};
    return {Diagnosis::NOT_ON_BORDER,
            is_null ? "the given halfedge is null, and must be on a border"
                    : "the given halfedge is not on a border: it has a face",
            {},
            {}};
  }

  // Sets the corner table, and the vertices in the order in which the faces come upon them. A face that is entered from
  // another one brings one vertex, which may be new.
  template <typename VertexIndexMap>
  Chart_defect find_faces(halfedge_descriptor inner, VertexIndexMap vimap)
  {
    const std::size_t most_faces = m_faces.begin();
    chart.opposite.reserve(3 * most_faces);
    chart.vertex.reserve(3 * most_faces);
    Vertex_ranks<typename boost::property_traits<VertexIndexMap>::value_type> ranks(
        24 * most_faces); // vertices are half as many as faces
    const auto find_vertex = [&](halfedge_descriptor h) {
      const vertex_descriptor v = target(h, m_mesh);
      int& rank = ranks[get(vimap, v)];
      if(rank < 0) {
        rank = static_cast<int>(vertex_descriptors.size());
        vertex_descriptors.push_back(v);
      }
      return rank;
    };
    std::vector<int>& vertex = chart.vertex;
    const auto enter = [&](int from) {
      const int target = from < 0 ? find_vertex(inner) : chart.edge_source(from);
      const int source = from < 0 ? find_vertex(prev(inner, m_mesh)) : chart.edge_target(from);
      vertex.insert(vertex.end(), {target, -1, source});
    };
    const auto visit = [&](int t) { vertex[3 * t + 1] = find_vertex(next(m_faces.entry(t), m_mesh)); };
    const auto is_cut = [](const auto&) { return false; };
    return m_faces.find_part(inner, is_cut, enter, visit, chart);
  }

  void read_points()
  {
    const auto points = get(CGAL::vertex_point, m_mesh);
    double largest = 0;
    vertex_descriptors.shrink_to_fit();
    if(!m_numbers)
      m_numbers = vertex_positions(m_mesh);
    chart.numbers.reserve(vertex_descriptors.size());
    chart.points.reserve(vertex_descriptors.size());
    for(vertex_descriptor v : vertex_descriptors) {
      chart.numbers.push_back(m_numbers(v));
      chart.points.push_back(m_points ? m_points(v, m_mesh) : point_in_doubles(get(points, v)));
      for(int i = 0; i < 3; ++i)
        largest = (std::max)(largest, std::abs(chart.points.back()[i]));
    }
    set_scale(power_of_two(largest), chart);
  }

  const TriangleMesh& m_mesh;
  Vertex_points<TriangleMesh> m_points;
  Vertex_numbers<TriangleMesh> m_numbers;
  Face_search<TriangleMesh> m_faces;
};

// Says in a report what is wrong with the chart that was read.
template <typename TriangleMesh, typename Report>
void report_defect(const Chart_defect& defect, const Chart_reader<TriangleMesh>& reader, Report& report)
{
  report.status = defect.status;
  report.message = defect.message;
  for(int v : defect.vertices)
    report.offending_vertices.push_back(reader.vertex_descriptors[v]);
  for(int t : defect.triangles)
    report.offending_faces.push_back(reader.face_of_triangle(t));
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_CHART_H
