// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Seams of any mesh: reads its parts and what edges cost as seams, finds seams of each part by a given function, marks
// them, and fills the report. The functions of `select_seams.h` and `select_crease_seams.h` differ only in that
// function.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_APPLY_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_APPLY_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/find_seams.h>
#include <CGAL/Texture_atlas/Seam_report.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

// The named parameter `edge_weight_map`, which CGAL has from the version on that has this header
#if !__has_include(<CGAL/boost/graph/dijkstra_shortest_path.h>)
namespace CGAL {

namespace internal_np {

enum edge_weight_t
{
  edge_weight
};

} // namespace internal_np

namespace parameters {

template <typename EdgeWeightMap>
Named_function_parameters<EdgeWeightMap, internal_np::edge_weight_t>
edge_weight_map(const EdgeWeightMap& weights)
{
  return Named_function_parameters<EdgeWeightMap, internal_np::edge_weight_t>(weights);
}

} // namespace parameters

} // namespace CGAL
#endif

namespace CGAL::Texture_atlas::internal {

// What an edge of a given length costs as a seam, by the named parameters: its weight or length, and infinity if it
// must not be one.
template <typename Edge, typename NamedParameters>
auto seam_cost(const NamedParameters& np)
{
  using parameters::get_parameter;
  const auto is_constrained = parameters::choose_parameter(
      get_parameter(np, internal_np::edge_is_constrained), Static_boolean_property_map<Edge, false>());
  return [is_constrained, &np](const Edge& e, double length) {
    if(get(is_constrained, e))
      return (std::numeric_limits<double>::infinity)();
    (void)np; // not used without weights
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::edge_weight_t>::value)
      return length;
    else
      return static_cast<double>(get(get_parameter(np, internal_np::edge_weight), e));
  };
}

// The vertices that seams have to reach, by the named parameters
template <typename TriangleMesh, typename NamedParameters>
auto terminal_map(const NamedParameters& np)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_is_constrained),
                                      Static_boolean_property_map<vertex_descriptor, false>());
}

// Vertices without faces cannot be reached.
template <typename TriangleMesh, typename NamedParameters>
bool can_reach_terminals(const TriangleMesh& mesh, const NamedParameters& np,
                         Mesh_report<TriangleMesh, Seam_report>& report)
{
  if constexpr(!parameters::is_default_parameter<NamedParameters,
                                                 internal_np::vertex_is_constrained_t>::value) {
    const auto is_terminal = terminal_map<TriangleMesh>(np);
    for(const auto v : vertices(mesh))
      if(get(is_terminal, v) && halfedge(v, mesh) == boost::graph_traits<TriangleMesh>::null_halfedge()) {
        report.status = Diagnosis::WRONG_OPTION;
        report.offending_vertices = {v};
        report.message = vertex_of_mesh_text(mesh, v, np) + " has no face, and so no seam can reach it";
        return false;
      }
  }
  return true;
}

// Reads a mesh, finds seams of each of its parts by `find(part)`, and marks them if all parts have some. With
// `keeps_seams`, the present ones are borders of the parts; otherwise `find()` gets them to change.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename NamedParameters>
class Seam_application
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  typedef Mesh_report<TriangleMesh, Seam_report> Report;

public:
  Seam_application(const TriangleMesh& mesh, EdgeIsSeamMap seams, const NamedParameters& np, bool keeps_seams)
      : m_mesh(mesh), m_seams(seams), m_np(np), m_keeps_seams(keeps_seams),
        m_reader(mesh,
                 parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                              get_const_property_map(CGAL::vertex_point, mesh)),
                 given_numbers<TriangleMesh>(np))
  {}

  template <typename Find>
  Report run(const Find& find)
  {
    Report report;
    if(!m_reader.read([&](edge_descriptor e) { return m_keeps_seams && get(m_seams, e); }, report) ||
       !m_reader.read_costs(seam_cost<edge_descriptor>(m_np), report))
      return report;
    std::vector<Seams> results;
    for(const Surface_part& part : m_reader.parts()) {
      Deadline::ask();
      results.push_back(find(part));
      if(results.back().status != Seams::DONE) {
        explain_failure(part, results.back().status, report);
        return report;
      }
    }
    measure(results, report);
    Deadline::ask();
    mark(results); // last, and without memory: seams are as they were if anything fails
    return report;
  }

  // Tells of each corner of a part whether the edge that it faces is a seam now.
  std::vector<char> seams_of(const Surface_part& part) const
  {
    std::vector<char> is_seam;
    for(int c = 0; c < part.chart.number_of_corners(); ++c)
      is_seam.push_back(part.chart.opposite[c] >= 0 &&
                        get(m_seams, m_reader.edge_of(3 * part.first_triangle + c)));
    return is_seam;
  }

  // The one to a corner of a part
  typename boost::graph_traits<TriangleMesh>::halfedge_descriptor halfedge_to(const Surface_part& part,
                                                                              int corner) const
  {
    return m_reader.halfedge_to(3 * part.first_triangle + corner);
  }

  // The vertices of a part that seams have to reach
  std::vector<int> terminals_of(const Surface_part& part) const
  {
    const auto is_terminal = terminal_map<TriangleMesh>(m_np);
    std::vector<int> result;
    std::vector<char> is_visited(part.chart.points.size(), false);
    for(int c = 0; c < part.chart.number_of_corners(); ++c)
      if(const int v = part.chart.vertex[c]; !is_visited[v]) {
        is_visited[v] = true;
        if(get(is_terminal, target(m_reader.halfedge_to(3 * part.first_triangle + c), m_mesh)))
          result.push_back(v);
      }
    return result;
  }

private:
  void explain_failure(const Surface_part& part, Seams::Status status, Report& report) const
  {
    report.offending_faces = {m_reader.face_of(part.first_triangle)};
    const std::string where = "the part of the surface with " + vertex_text(part.chart, 0);
    if(status == Seams::NO_CUT)
      m_reader.fail(
          report, Diagnosis::NO_CUT_ALLOWED,
          where + " cannot be cut to a disk along the edges that may become seams" +
              (parameters::is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value
                   ? ""
                   : ", through the vertices that must be reached"));
    else
      m_reader.fail(report, Diagnosis::LINEAR_SYSTEM_FAILED,
                    "the linear system that predicts the scale could not be solved for " + where);
  }

  // Where seams were kept, no other edge has a mark.
  void mark(const std::vector<Seams>& results)
  {
    for(std::size_t i = 0; i < results.size(); ++i) {
      const Surface_part& part = m_reader.parts()[i];
      for(int c = 0; c < part.chart.number_of_corners(); ++c)
        if(part.chart.opposite[c] > c && (results[i].is_seam[c] || !m_keeps_seams))
          put(m_seams, m_reader.edge_of(3 * part.first_triangle + c), bool(results[i].is_seam[c]));
    }
  }

  // Seams lie between two corners, of one part or of two.
  void measure(const std::vector<Seams>& results, Report& report) const
  {
    double area = 0, sides = 0;
    for(std::size_t i = 0; i < results.size(); ++i) {
      const Surface_part& part = m_reader.parts()[i];
      for(int t = 0; t < part.chart.number_of_triangles(); ++t)
        area += surface_area(part.chart, t);
      for(int c = 0; c < part.chart.number_of_corners(); ++c)
        if(results[i].is_seam[c] || is_seam_at_border(part, c))
          sides += edge_length(part.chart, c);
      report.number_of_disks += count_pieces(part.chart, results[i].is_seam);
      report.number_of_terminals += results[i].terminals.size();
      report.predicted_stretch = (std::max)(report.predicted_stretch, results[i].predicted_stretch);
    }
    report.number_of_components = m_reader.count_components();
    report.seam_length = sides / 2 * m_reader.scale();
    report.relative_seam_length = area > 0 ? sides / 2 / std::sqrt(area) : 0;
  }

  // The number of pieces that the seams cut a part into
  static std::size_t count_pieces(const Chart& chart, const std::vector<char>& is_seam)
  {
    std::size_t count = 0;
    std::vector<char> is_found(chart.number_of_triangles(), false);
    std::vector<int> found;
    const auto find = [&](int t) {
      if(!is_found[t])
        found.push_back(t);
      is_found[t] = true;
    };
    for(int first = 0; first < chart.number_of_triangles(); ++first) {
      count += !is_found[first];
      find(first);
      while(!found.empty()) {
        const int t = found.back();
        found.pop_back();
        for(int c = 3 * t; c < 3 * t + 3; ++c)
          if(chart.opposite[c] >= 0 && !is_seam[c])
            find(chart.opposite[c] / 3);
      }
    }
    return count;
  }

  bool is_seam_at_border(const Surface_part& part, int c) const
  {
    if(part.chart.opposite[c] >= 0)
      return false;
    const edge_descriptor e = m_reader.edge_of(3 * part.first_triangle + c);
    return get(m_seams, e) && !CGAL::is_border(e, m_mesh);
  }

  const TriangleMesh& m_mesh;
  EdgeIsSeamMap m_seams;
  const NamedParameters& m_np;
  bool m_keeps_seams;
  Surface_reader<TriangleMesh, Vertex_point_map, Report> m_reader;
};

} // namespace CGAL::Texture_atlas::internal

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/seams/find_seams_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_APPLY_SEAMS_H
