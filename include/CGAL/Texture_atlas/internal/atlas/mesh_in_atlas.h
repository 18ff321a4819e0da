// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One of the caller's meshes, with its charts: lists and measures them, and writes coordinates. `mesh_atlas_builder.h`
// makes an atlas of one or several of them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MESH_IN_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MESH_IN_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Texture_atlas/internal/atlas/mesh_components.h>
#include <CGAL/Texture_atlas/internal/atlas/read_atlas_mesh.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// A mesh, as it was read, with its charts. Writes the results. Maps of seams and charts may be null pointers.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap, typename FaceChartMap,
          typename NamedParameters>
class Mesh_in_atlas
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef Atlas_mesh_reader<TriangleMesh, EdgeIsSeamMap, HalfedgeUVMap, NamedParameters> Reader;
  typedef typename boost::property_traits<HalfedgeUVMap>::value_type Point;
  typedef Mesh_atlas_report<TriangleMesh> Report;
  typedef typename Report::Part_elements Part_elements;
  static constexpr bool has_seams = !std::is_same<EdgeIsSeamMap, std::nullptr_t>::value;
  static constexpr bool has_charts = !std::is_same<FaceChartMap, std::nullptr_t>::value;

public:
  struct Listed_part
  {
    typename Report::Skipped part; // with a diagnosis if it is skipped
    bool is_read;
    Part_elements elements; // if it is skipped
  };

  Mesh_in_atlas(const TriangleMesh& mesh, EdgeIsSeamMap seams, HalfedgeUVMap uv, FaceChartMap charts,
                bool keeps_charts, const NamedParameters& np)
      : input(mesh, seams, uv, keeps_charts, np), m_mesh(mesh), m_seams(seams), m_uv(uv), m_charts(charts),
        m_without_area(mesh, input.points)
  {}

  // The parts are taken away while the atlas is made.
  std::vector<Surface_part> release_parts() { return std::move(input.surface.parts()); }

  // The parts come back with their charts.
  void set_charts(std::vector<Surface_part>&& parts, std::vector<Part_atlas>&& charts,
                  std::vector<std::size_t>&& first_chart)
  {
    const int first = parts.empty() ? 0 : parts.front().first_triangle; // in this mesh, it is 0
    for(Surface_part& part : parts)
      part.first_triangle -= first;
    input.surface.parts() = std::move(parts);
    m_atlas = std::move(charts);
    m_first_chart = std::move(first_chart);
    if(!m_first_chart.empty()) // some part was read, and charts that are given can be kept
      m_without_area.place(input.components.faces_without_area(),
                           [this](halfedge_descriptor h) { return corner_at(h); });
  }

  std::size_t number_of_faces() const { return faces(m_mesh).size(); }
  std::size_t number_of_degenerate_faces() const { return m_without_area.charts().size(); }

  // By their first faces, those that were read and those that cannot be flattened
  std::vector<Listed_part> listed_parts() const
  {
    std::vector<Listed_part> parts;
    for(const auto& bad : input.components.bad_components())
      if(m_without_area.charts().count(bad.faces.front()) == 0)
        parts.push_back({skipped(bad.first_face, bad.number_of_faces, bad.status, bad.message),
                         false,
                         {bad.faces, bad.vertices}});
    for(std::size_t i = 0; i < m_atlas.size(); ++i) {
      const Surface_part& part = input.surface.parts()[i];
      const auto triangles = static_cast<std::size_t>(part.chart.number_of_triangles());
      parts.push_back({skipped(input.components.rank(input.surface.face_of(part.first_triangle)), triangles,
                               m_atlas[i].status, m_atlas[i].message),
                       true, elements(part, m_atlas[i])});
    }
    Vertex_numbers<TriangleMesh> position; // takes time that few meshes need
    for(Listed_part& listed : parts)
      for(const auto& v : listed.elements.vertices) {
        if(!position)
          position = vertex_positions(m_mesh);
        listed.part.vertices.push_back(static_cast<std::size_t>(position(v)));
      }
    std::sort(parts.begin(), parts.end(), [](const Listed_part& p, const Listed_part& q) {
      return p.part.first_face < q.part.first_face;
    });
    return parts;
  }

  // The first face of each chart that is not good. Pieces are numbered by their first triangles.
  void name_bad_charts(Report& report) const
  {
    for(std::size_t i = 0; i < m_atlas.size(); ++i) {
      int pieces = 0;
      for(std::size_t t = 0; m_atlas[i].succeeded() && t < m_atlas[i].piece.size(); ++t)
        if(m_atlas[i].piece[t] == pieces)
          if(!report.charts[m_first_chart[i] + static_cast<std::size_t>(pieces++)].is_good)
            report.offending_faces.push_back(
                input.surface.face_of(input.surface.parts()[i].first_triangle + static_cast<int>(t)));
    }
  }

  // Adds the positions of the faces with a corner that is not on a grid, with those of the meshes before.
  void list_faces_off_grid(const Quantization_grid& grid, std::size_t first,
                           std::vector<std::size_t>& faces) const
  {
    for(std::size_t i = 0; i < m_atlas.size(); ++i) {
      const Part_atlas& atlas = m_atlas[i];
      const auto is_off = [&](int c) { return !grid.has(atlas.uv[atlas.chart.vertex[c]]); };
      for(int t = 0; atlas.succeeded() && t < atlas.chart.number_of_triangles(); ++t)
        if(is_off(3 * t) || is_off(3 * t + 1) || is_off(3 * t + 2))
          faces.push_back(first + input.components.rank(
                                      input.surface.face_of(input.surface.parts()[i].first_triangle + t)));
    }
  }

  // Adds the lengths of the sides of seams, which lie between two corners, and the area that has charts.
  void measure_seams(double& sides, double& area) const
  {
    for(std::size_t i = 0; i < m_atlas.size(); ++i) {
      const Surface_part& part = input.surface.parts()[i];
      const Part_atlas& atlas = m_atlas[i];
      if(!atlas.succeeded())
        continue;
      for(int c = 0; c < part.chart.number_of_corners(); ++c)
        if(is_seam(part, atlas, c))
          sides += edge_length(part.chart, c);
      for(int t = 0; t < part.chart.number_of_triangles(); ++t)
        area += surface_area(part.chart, t);
    }
  }

  // Before coordinates are written, which tell the seams that are kept, and while memory may run out
  void prepare_to_write()
  {
    if constexpr(has_seams)
      for(std::size_t i = 0; i < m_atlas.size(); ++i) {
        const Surface_part& part = input.surface.parts()[i];
        for(int c = 0; m_atlas[i].succeeded() && c < part.chart.number_of_corners(); ++c)
          if(is_seam(part, m_atlas[i], c))
            m_new_seams.push_back(input.surface.edge_of(3 * part.first_triangle + c));
      }
    if constexpr(has_seams)
      if(input.components.has_defects() && !m_first_chart.empty()) // some part was read
        for(edge_descriptor e : edges(m_mesh))
          if(!CGAL::is_border(e, m_mesh) && input.components.is_beside_defect(e) && !is_joined(e))
            m_new_seams.push_back(e);
  }

  void write()
  {
    if constexpr(has_seams)
      for(edge_descriptor e : m_new_seams)
        put(m_seams, e, true);
    for(std::size_t i = 0; i < m_atlas.size(); ++i) {
      const Surface_part& part = input.surface.parts()[i];
      const Part_atlas& atlas = m_atlas[i];
      for(int c = 0; atlas.succeeded() && c < part.chart.number_of_corners(); ++c)
        put(m_uv, input.surface.halfedge_to(3 * part.first_triangle + c),
            planar_point<Point>(atlas.uv[atlas.chart.vertex[c]]));
    }
    for(const auto& [h, p] : m_without_area.uv())
      put(m_uv, h, planar_point<Point>(p));
    if constexpr(has_charts)
      write_charts();
  }

  Reader input;

private:
  static typename Report::Skipped skipped(std::size_t first_face, std::size_t faces, Diagnosis status,
                                          const std::string& message)
  {
    typename Report::Skipped part;
    part.first_face = first_face;
    part.number_of_faces = faces;
    part.status = status;
    part.message = message;
    return part;
  }

  // Of a part that has no charts although it was read; nothing for others
  Part_elements elements(const Surface_part& part, const Part_atlas& atlas) const
  {
    Part_elements result;
    if(atlas.succeeded())
      return result;
    for(int t = 0; t < part.chart.number_of_triangles(); ++t)
      result.faces.push_back(input.surface.face_of(part.first_triangle + t));
    std::sort(result.faces.begin(), result.faces.end(), [this](face_descriptor f, face_descriptor g) {
      return input.components.rank(f) < input.components.rank(g);
    });
    if(atlas.wrong_corner >= 0)
      result.vertices.push_back(
          target(input.surface.halfedge_to(3 * part.first_triangle + atlas.wrong_corner), m_mesh));
    return result;
  }

  bool is_seam(const Surface_part& part, const Part_atlas& atlas, int c) const
  {
    if(atlas.chart.opposite[c] >= 0)
      return false;
    const edge_descriptor e = input.surface.edge_of(3 * part.first_triangle + c);
    return part.chart.opposite[c] >= 0 || (!CGAL::is_border(e, m_mesh) && input.is_given_seam(e));
  }

  void write_charts() const
  {
    typedef typename boost::property_traits<FaceChartMap>::value_type Number;
    static_assert(std::is_signed<Number>::value, "faces without a chart get -1");
    for(face_descriptor f : faces(m_mesh))
      put(m_charts, f, Number(-1));
    for(std::size_t i = 0; i < m_atlas.size(); ++i)
      for(std::size_t t = 0; m_atlas[i].succeeded() && t < m_atlas[i].piece.size(); ++t)
        put(m_charts, input.surface.face_of(input.surface.parts()[i].first_triangle + static_cast<int>(t)),
            static_cast<Number>(m_first_chart[i] + static_cast<std::size_t>(m_atlas[i].piece[t])));
    for(const auto& [f, chart] : m_without_area.charts())
      put(m_charts, f, static_cast<Number>(chart));
  }

  // Whether both faces of an edge have the same coordinates there, or none
  bool is_joined(edge_descriptor e) const
  {
    const halfedge_descriptor h = halfedge(e, m_mesh), o = opposite(h, m_mesh);
    return uv_at(h) == uv_at(prev(o, m_mesh)) && uv_at(o) == uv_at(prev(h, m_mesh));
  }

  std::optional<Chart::Point_2> uv_at(halfedge_descriptor h) const
  {
    if(const auto found = m_without_area.uv().find(h); found != m_without_area.uv().end())
      return found->second;
    const std::optional<Corner_in_atlas> corner = corner_at(h);
    return corner ? std::optional(corner->uv) : std::nullopt;
  }

  // The corner that a halfedge of a face points to, if the face is in a chart
  std::optional<Corner_in_atlas> corner_at(halfedge_descriptor h) const
  {
    const int triangle = input.surface.triangle_of(face(h, m_mesh));
    const std::size_t i = triangle < 0 ? m_atlas.size() : input.surface.part_of(triangle);
    if(i >= m_atlas.size() || !m_atlas[i].succeeded())
      return std::nullopt;
    int c = 3 * triangle;
    while(input.surface.halfedge_to(c) != h)
      ++c;
    c -= 3 * input.surface.parts()[i].first_triangle;
    return Corner_in_atlas{m_atlas[i].uv[m_atlas[i].chart.vertex[c]],
                           m_first_chart[i] + static_cast<std::size_t>(m_atlas[i].piece[c / 3])};
  }

  const TriangleMesh& m_mesh;
  EdgeIsSeamMap m_seams;
  HalfedgeUVMap m_uv;
  FaceChartMap m_charts;
  Faces_without_area<TriangleMesh, typename Reader::Vertex_point_map> m_without_area;
  std::vector<Part_atlas> m_atlas;        // of each part
  std::vector<std::size_t> m_first_chart; // of each part
  std::vector<edge_descriptor> m_new_seams;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MESH_IN_ATLAS_H
