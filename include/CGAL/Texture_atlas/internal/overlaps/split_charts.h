// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `split_overlaps()` for any mesh: reads charts and coordinates, separates their overlaps, and writes seams and pieces.
// It is the only layer of this folder that knows the mesh; `separate_overlaps.h` sees flat arrays.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_SPLIT_CHARTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_SPLIT_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/Seam_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Texture_atlas/internal/overlaps/separate_overlaps.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/internal/seams/apply_seams.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Splits the charts of a mesh where they overlap themselves, and marks seams and pieces if that succeeds.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename UVMap, typename NamedParameters>
class Chart_splitter
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  typedef Mesh_report<TriangleMesh, Overlap_split_report> Report;
  typedef Exact_point<typename boost::property_traits<UVMap>::value_type> Convert;
  typedef typename Convert::type Point;

public:
  Chart_splitter(const TriangleMesh& mesh, EdgeIsSeamMap seams, UVMap uv, const NamedParameters& np)
      : m_mesh(mesh), m_seams(seams), m_uv(mesh, uv), m_np(np),
        m_reader(mesh,
                 parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                              get_const_property_map(CGAL::vertex_point, mesh)),
                 given_numbers<TriangleMesh>(np))
  {}

  template <typename FaceChartMap>
  Report run(FaceChartMap chart_map)
  {
    Report report;
    if(!m_reader.read([this](edge_descriptor e) { return get(m_seams, e); }, report) ||
       !m_reader.read_costs(seam_cost<edge_descriptor>(m_np), report))
      return report;
    std::vector<Separation> separations;
    for(const Surface_part& part : m_reader.parts()) {
      std::vector<Point> uv;
      if(!read_uv(part, uv, report))
        return report;
      separations.push_back(separate_overlaps(part.chart, part.cost, uv));
      if(separations.back().status != Separation::DONE) {
        explain_failure(part, separations.back(), report);
        return report;
      }
      count(part, separations.back(), report);
    }
    report.border_length *= m_reader.scale();
    report.added_seam_length *= m_reader.scale();
    mark_seams(separations);
    mark_pieces(separations, chart_map);
    return report;
  }

private:
  bool read_uv(const Surface_part& part, std::vector<Point>& uv, Report& report) const
  {
    const Chart& chart = part.chart;
    uv.resize(chart.points.size());
    std::vector<char> is_read(chart.points.size(), false);
    for(int c = 0; c < chart.number_of_corners(); ++c) {
      const int v = chart.vertex[c];
      const Point p = Convert::get(m_uv[m_reader.halfedge_to(3 * part.first_triangle + c)]);
      if(!is_finite_point(p)) {
        report.offending_vertices = {m_reader.vertex_of(part, v)};
        m_reader.fail(report, Diagnosis::NON_FINITE_COORDINATE,
                      vertex_text(chart, v) +
                          " has coordinates in the plane that are not all finite numbers");
        return false;
      }
      if(is_read[v] && uv[v] != p) {
        report.offending_vertices = {m_reader.vertex_of(part, v)};
        m_reader.fail(report, Diagnosis::INCONSISTENT_COORDINATES,
                      vertex_text(chart, v) + " has different coordinates at faces that no seam separates");
        return false;
      }
      uv[v] = p;
      is_read[v] = true;
    }
    return true;
  }

  void explain_failure(const Surface_part& part, const Separation& separation, Report& report) const
  {
    const Chart& chart = part.chart;
    const int c = 3 * separation.triangle;
    report.offending_faces = {m_reader.face_of(part.first_triangle + separation.triangle)};
    const std::string face = "the face of " + vertex_text(chart, chart.vertex[c]) + ", " +
                             vertex_text(chart, chart.vertex[c + 1]) + " and " +
                             vertex_text(chart, chart.vertex[c + 2]);
    if(separation.status == Separation::FLIPPED)
      m_reader.fail(report, Diagnosis::FLIPPED_TRIANGLES, face + " is not positively oriented in the plane");
    else if(separation.status == Separation::NO_CUT)
      m_reader.fail(report, Diagnosis::NO_CUT_ALLOWED,
                    face + " overlaps another one, and the edges that may become seams do not separate them");
    else
      m_reader.fail(report, Diagnosis::NOT_CERTIFIED,
                    "the map of the piece with " + face.substr(4) +
                        " could not be certified to be injective");
  }

  void count(const Surface_part& part, const Separation& separation, Report& report) const
  {
    ++report.number_of_charts;
    report.number_of_pieces += separation.number_of_pieces;
    if(separation.overlaps.empty())
      return;
    ++report.number_of_overlapping_charts;
    report.number_of_overlapping_faces +=
        std::count(separation.overlaps.begin(), separation.overlaps.end(), true);
    for(int c = 0; c < part.chart.number_of_corners(); ++c)
      if(part.chart.opposite[c] < 0)
        report.border_length += edge_length(part.chart, c);
      else if(separation.is_seam[c])
        report.added_seam_length += edge_length(part.chart, c) / 2;
    report.extra_seam = report.border_length > 0 ? 2 * report.added_seam_length / report.border_length : 0;
  }

  void mark_seams(const std::vector<Separation>& separations)
  {
    for(std::size_t i = 0; i < separations.size(); ++i) {
      const Surface_part& part = m_reader.parts()[i];
      for(int c = 0; c < part.chart.number_of_corners(); ++c)
        if(separations[i].is_seam[c])
          put(m_seams, m_reader.edge_of(3 * part.first_triangle + c), true);
    }
  }

  // Pieces are numbered by their first faces.
  template <typename FaceChartMap>
  void mark_pieces(const std::vector<Separation>& separations, FaceChartMap chart_map)
  {
    typedef typename boost::property_traits<FaceChartMap>::value_type Number;
    const auto piece = get(CGAL::dynamic_face_property_t<std::size_t>(), m_mesh);
    std::size_t first = 0;
    for(std::size_t i = 0; i < separations.size(); ++i) {
      const Surface_part& part = m_reader.parts()[i];
      for(int t = 0; t < part.chart.number_of_triangles(); ++t)
        put(piece, m_reader.face_of(part.first_triangle + t), first + separations[i].piece[t]);
      first += separations[i].number_of_pieces;
    }
    std::vector<std::size_t> number(first, first);
    std::size_t count = 0;
    for(auto f : faces(m_mesh)) {
      std::size_t& n = number[get(piece, f)];
      if(n == first)
        n = count++;
      put(chart_map, f, static_cast<Number>(n));
    }
  }

  const TriangleMesh& m_mesh;
  EdgeIsSeamMap m_seams;
  const Corner_coordinates<TriangleMesh, UVMap> m_uv;
  const NamedParameters& m_np;
  Surface_reader<TriangleMesh, Vertex_point_map, Report> m_reader;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_SPLIT_CHARTS_H
