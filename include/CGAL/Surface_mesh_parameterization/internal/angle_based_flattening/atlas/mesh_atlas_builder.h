// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The side of `make_atlas()` that knows the caller's mesh: reads options, components and weights, and writes
// coordinates and charts. Included by `make_atlas.h`. The atlas itself is made by `build_atlas()`, which sees only
// charts.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_MESH_ATLAS_BUILDER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_MESH_ATLAS_BUILDER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Atlas_report.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/Seam_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/atlas_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/build_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/part_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/write_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/default_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/seam_cost.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Reads a mesh for `make_atlas()`, and writes the results. Maps of seams and charts may be null pointers.
template <typename TriangleMesh, typename EdgeIsSeamMap, typename HalfedgeUVMap, typename FaceChartMap,
          typename NamedParameters>
class Mesh_atlas_builder
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  typedef typename boost::property_traits<HalfedgeUVMap>::value_type Point;
  typedef Mesh_report<TriangleMesh, Atlas_report> Report;
  static constexpr bool has_seams = !std::is_same<EdgeIsSeamMap, std::nullptr_t>::value;
  static constexpr bool has_charts = !std::is_same<FaceChartMap, std::nullptr_t>::value;
  static constexpr bool has_polygons =
      !parameters::is_default_parameter<NamedParameters, internal_np::face_patch_t>::value;

  // A component that cannot be flattened, because of one of its faces
  struct Bad_component
  {
    std::size_t component;
    Diagnosis status;
    std::string message;
    face_descriptor face; // that is wrong
  };

public:
  Mesh_atlas_builder(const TriangleMesh& mesh, EdgeIsSeamMap seams, HalfedgeUVMap uv, FaceChartMap charts,
                     const Atlas_options& options, const NamedParameters& np)
      : m_mesh(mesh), m_seams(seams), m_uv(uv), m_charts(charts), m_options(options), m_np(np),
        m_points(parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                              get_const_property_map(CGAL::vertex_point, mesh))),
        m_reader(mesh, m_points)
  {}

  Report run()
  {
    Report report;
    report.message = wrong_option(m_options);
    if(!report.message.empty()) {
      report.status = Diagnosis::WRONG_OPTION;
      return report;
    }
    with_threads(m_options.threads, [&]() {
      try {
        report = make();
      } catch(const Cancelled&) {
        report = Report();
        report.status = Diagnosis::CANCELLED;
        report.message = "a visitor stopped the computation";
      }
    });
    return report;
  }

private:
  Report make()
  {
    Report report;
    Real_timer timer;
    timer.start();
    begin(Atlas_visitor::READ);
    const bool is_read = read(report);
    const double seconds = timer.time();
    if(!is_read)
      return report;
    const Linear_solvers solvers = linear_solvers(m_np);
    Atlas_settings options = m_options;
    options.texels_per_unit *= m_weight_scale;
    m_atlas = build_atlas(m_reader.parts(), m_weight, options, solvers, &round_to_points<Point>);
    static_cast<Atlas_report&>(report) = std::move(m_atlas.report);
    report.seconds.read = seconds;
    if(m_options.pack_into_square)
      report.scale /= m_weight_scale;
    list_parts(report);
    name_bad_charts(report);
    if(!report.has_atlas())
      return report;
    measure_seams(report);
    timer.reset();
    begin(Atlas_visitor::WRITE);
    write();
    report.seconds.write = timer.time();
    return report;
  }

  void begin(Atlas_visitor::Stage stage) const
  {
    if(m_options.visitor != nullptr && !m_options.visitor->start(stage))
      throw Cancelled();
  }

  bool is_given_seam(edge_descriptor e) const
  {
    if constexpr(has_seams)
      return get(m_seams, e);
    else {
      (void)e;
      return false;
    }
  }

  // Whether both faces of an edge are parts of one polygon
  bool is_in_polygon(edge_descriptor e) const
  {
    const auto polygons = parameters::get_parameter(m_np, internal_np::face_patch);
    const halfedge_descriptor h = halfedge(e, m_mesh);
    return !CGAL::is_border(e, m_mesh) &&
           get(polygons, face(h, m_mesh)) == get(polygons, face(opposite(h, m_mesh), m_mesh));
  }

  // Returns whether there is something to flatten.
  bool read(Report& report)
  {
    const bool has_faces = find_components();
    if(has_faces && !m_bad.empty() && m_bad.size() == m_number_of_components) {
      list_parts(report);
      report.status = Diagnosis::NOTHING_FLATTENED;
      report.message = "no part of the surface can be flattened";
      return false;
    }
    const auto is_given = [this](edge_descriptor e) { return is_given_seam(e); };
    const auto is_skipped = [this](face_descriptor f) { return m_is_bad[get(m_component, f)]; };
    Mesh_report<TriangleMesh, Seam_report> reading;
    if(m_reader.read(is_given, is_skipped, reading) &&
       m_reader.read_costs(seam_cost<edge_descriptor>(m_np), reading)) {
      if constexpr(has_polygons)
        m_reader.read_diagonals([this](edge_descriptor e) { return is_in_polygon(e); });
      return read_weights(report);
    }
    report.message = reading.message;
    report.offending_edges = reading.offending_edges;
    report.status = reading.status == Diagnosis::EMPTY_MESH     ? Diagnosis::EMPTY_MESH
                    : reading.status == Diagnosis::WRONG_WEIGHT ? Diagnosis::WRONG_WEIGHT
                                                                : Diagnosis::TOO_LARGE;
    return false;
  }

  // Finds the components, opened along the given seams, that are no triangulated surfaces in space. Returns whether
  // there are faces.
  bool find_components()
  {
    m_component = get(CGAL::dynamic_face_property_t<std::size_t>(), m_mesh);
    m_rank = get(CGAL::dynamic_face_property_t<std::size_t>(), m_mesh);
    m_number_of_components = Polygon_mesh_processing::connected_components(
        m_mesh, m_component,
        parameters::edge_is_constrained_map(boost::make_function_property_map<edge_descriptor>(
            [this](edge_descriptor e) { return is_given_seam(e); })));
    m_is_bad.assign(m_number_of_components, false);
    std::size_t rank = 0;
    for(face_descriptor f : faces(m_mesh)) {
      put(m_rank, f, rank++);
      const std::size_t component = get(m_component, f);
      const Diagnosis diagnosis = m_is_bad[component] ? Diagnosis::NOTHING_WRONG : defect(f);
      if(diagnosis == Diagnosis::NOTHING_WRONG)
        continue;
      m_is_bad[component] = true;
      m_bad.push_back({component, diagnosis, message(f, diagnosis), f});
    }
    return rank > 0;
  }

  Diagnosis defect(face_descriptor f) const
  {
    if(!CGAL::is_triangle(halfedge(f, m_mesh), m_mesh))
      return Diagnosis::NOT_TRIANGULATED;
    for(halfedge_descriptor h : CGAL::halfedges_around_face(halfedge(f, m_mesh), m_mesh)) {
      const auto& p = get(m_points, target(h, m_mesh));
      if(!(CGAL::is_finite(CGAL::to_double(p.x())) && CGAL::is_finite(CGAL::to_double(p.y())) &&
           CGAL::is_finite(CGAL::to_double(p.z()))))
        return Diagnosis::NON_FINITE_POINT;
    }
    return Diagnosis::NOTHING_WRONG;
  }

  std::string message(face_descriptor f, Diagnosis diagnosis) const
  {
    const auto& p = get(m_points, target(halfedge(f, m_mesh), m_mesh));
    std::ostringstream text;
    text << "face " << get(m_rank, f) << " at (" << CGAL::to_double(p.x()) << ", " << CGAL::to_double(p.y())
         << ", " << CGAL::to_double(p.z()) << ") "
         << (diagnosis == Diagnosis::NOT_TRIANGULATED
                 ? "is not a triangle: call Polygon_mesh_processing::triangulate_faces() first"
                 : "has a vertex whose coordinates are not all finite");
    return text.str();
  }

  bool read_weights(Report& report)
  {
    if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::face_size_map_t>::value) {
      const auto weights = parameters::get_parameter(m_np, internal_np::face_size_map);
      for(const Surface_part& part : m_reader.parts())
        for(int t = 0; t < part.chart.number_of_triangles(); ++t) {
          const face_descriptor f = m_reader.face_of(part.first_triangle + t);
          m_weight.push_back(CGAL::to_double(get(weights, f)));
          if(!(m_weight.back() >= 0 && CGAL::is_finite(m_weight.back()))) {
            report.status = Diagnosis::WRONG_WEIGHT;
            report.offending_faces = {f};
            report.message = "face " + std::to_string(get(m_rank, f)) + " has the weight " +
                             std::to_string(m_weight.back()) +
                             ", and weights must be finite and not negative";
            return false;
          }
        }
      const double largest = m_weight.empty() ? 0 : *std::max_element(m_weight.begin(), m_weight.end());
      m_weight_scale = power_of_two(largest);
      for(double& weight : m_weight) // so that no square underflows or overflows
        weight /= m_weight_scale;
    }
    return true;
  }

  struct Listed_part
  {
    typename Report::Skipped part; // with a diagnosis if it is skipped
    bool is_read;
    face_descriptor face; // that is wrong, or the first one
  };

  std::vector<Listed_part> listed_parts() const
  {
    std::vector<Listed_part> parts;
    std::vector<std::size_t> size(m_number_of_components, 0), first(m_number_of_components, 0);
    for(face_descriptor f : faces(m_mesh))
      if(size[get(m_component, f)]++ == 0)
        first[get(m_component, f)] = get(m_rank, f);
    for(const Bad_component& bad : m_bad)
      parts.push_back(
          {{0, first[bad.component], size[bad.component], bad.status, bad.message}, false, bad.face});
    for(std::size_t i = 0; i < m_atlas.parts.size(); ++i) {
      const Surface_part& part = m_reader.parts()[i];
      parts.push_back({{0, get(m_rank, m_reader.face_of(part.first_triangle)),
                        static_cast<std::size_t>(part.chart.number_of_triangles()), m_atlas.parts[i].status,
                        m_atlas.parts[i].message},
                       true,
                       m_reader.face_of(part.first_triangle)});
    }
    std::sort(parts.begin(), parts.end(), [](const Listed_part& p, const Listed_part& q) {
      return p.part.first_face < q.part.first_face;
    });
    return parts;
  }

  // Numbers the parts by their first faces, and says which were skipped.
  void list_parts(Report& report) const
  {
    std::vector<Listed_part> parts = listed_parts();
    std::vector<std::size_t> numbers; // of the parts that were read
    for(std::size_t i = 0; i < parts.size(); ++i) {
      parts[i].part.part = i;
      if(parts[i].is_read)
        numbers.push_back(i);
      if(parts[i].part.status != Diagnosis::NOTHING_WRONG) {
        report.skipped.push_back(parts[i].part);
        report.offending_faces.push_back(parts[i].face);
      }
    }
    report.number_of_parts = parts.size();
    for(typename Report::Chart& chart : report.charts)
      chart.part = numbers[chart.part];
    if(!report.skipped.empty() && report.has_atlas()) {
      report.status = Diagnosis::SOMETHING_SKIPPED;
      report.message = std::to_string(report.skipped.size()) + " of " + std::to_string(parts.size()) +
                       " parts of the surface have no charts; the first: " + report.skipped.front().message;
    }
  }

  // The first face of each chart that is not good, if that is what is wrong
  void name_bad_charts(Report& report) const
  {
    if(report.status != Diagnosis::STRETCH_BOUND_MISSED)
      return;
    for(std::size_t i = 0; i < m_atlas.parts.size(); ++i) {
      const Part_atlas& atlas = m_atlas.parts[i];
      for(std::size_t p = 0; p < atlas.pieces.size(); ++p) {
        if(report.charts[m_atlas.first_chart[i] + p].is_good)
          continue;
        const auto first = std::find(atlas.piece.begin(), atlas.piece.end(), static_cast<int>(p));
        report.offending_faces.push_back(m_reader.face_of(m_reader.parts()[i].first_triangle +
                                                          static_cast<int>(first - atlas.piece.begin())));
      }
    }
  }

  bool is_seam(const Surface_part& part, const Part_atlas& atlas, int c) const
  {
    if(atlas.chart.opposite[c] >= 0)
      return false;
    const edge_descriptor e = m_reader.edge_of(3 * part.first_triangle + c);
    return part.chart.opposite[c] >= 0 || (!CGAL::is_border(e, m_mesh) && is_given_seam(e));
  }

  // Seams lie between two corners, of one part or of two.
  void measure_seams(Report& report) const
  {
    double sides = 0, area = 0;
    for(std::size_t i = 0; i < m_atlas.parts.size(); ++i) {
      const Surface_part& part = m_reader.parts()[i];
      const Part_atlas& atlas = m_atlas.parts[i];
      if(!atlas.succeeded())
        continue;
      for(int c = 0; c < part.chart.number_of_corners(); ++c)
        if(is_seam(part, atlas, c))
          sides += edge_length(part.chart, c);
      for(int t = 0; t < part.chart.number_of_triangles(); ++t)
        area += surface_area(part.chart, t);
    }
    report.seam_length = sides / 2 * m_reader.scale();
    report.relative_seam_length = sides / 2 / std::sqrt(area);
  }

  void write()
  {
    for(std::size_t i = 0; i < m_atlas.parts.size(); ++i) {
      const Surface_part& part = m_reader.parts()[i];
      const Part_atlas& atlas = m_atlas.parts[i];
      if(!atlas.succeeded())
        continue;
      for(int c = 0; c < part.chart.number_of_corners(); ++c)
        put(m_uv, m_reader.halfedge_to(3 * part.first_triangle + c),
            planar_point<Point>(atlas.uv[atlas.chart.vertex[c]]));
      if constexpr(has_seams)
        for(int c = 0; c < part.chart.number_of_corners(); ++c)
          if(part.chart.opposite[c] > c && atlas.chart.opposite[c] < 0)
            put(m_seams, m_reader.edge_of(3 * part.first_triangle + c), true);
    }
    if constexpr(has_charts)
      write_charts();
  }

  void write_charts() const
  {
    typedef typename boost::property_traits<FaceChartMap>::value_type Number;
    static_assert(std::is_signed<Number>::value, "faces without a chart get -1");
    for(face_descriptor f : faces(m_mesh))
      put(m_charts, f, Number(-1));
    for(std::size_t i = 0; i < m_atlas.parts.size(); ++i)
      for(std::size_t t = 0; m_atlas.parts[i].succeeded() && t < m_atlas.parts[i].piece.size(); ++t)
        put(m_charts, m_reader.face_of(m_reader.parts()[i].first_triangle + static_cast<int>(t)),
            static_cast<Number>(m_atlas.first_chart[i] +
                                static_cast<std::size_t>(m_atlas.parts[i].piece[t])));
  }

  const TriangleMesh& m_mesh;
  EdgeIsSeamMap m_seams;
  HalfedgeUVMap m_uv;
  FaceChartMap m_charts;
  const Atlas_settings m_options;
  const NamedParameters& m_np;
  Vertex_point_map m_points;
  Surface_reader<TriangleMesh, Vertex_point_map, Mesh_report<TriangleMesh, Seam_report>> m_reader;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<std::size_t>>::const_type
      m_component,
      m_rank; // of each face
  std::size_t m_number_of_components = 0;
  std::vector<char> m_is_bad; // of each component
  std::vector<Bad_component> m_bad;
  std::vector<double> m_weight; // of each triangle, divided by the scale; empty if all are 1
  double m_weight_scale = 1;
  Atlas m_atlas;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_MESH_ATLAS_BUILDER_H
