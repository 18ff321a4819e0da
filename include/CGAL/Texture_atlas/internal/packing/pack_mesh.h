// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// `pack_charts()` for any mesh: numbers the charts, reads areas and coordinates, and writes those of the packed atlas.
// It is the only layer of this folder that knows the mesh. What it writes is certified after rounding to the type of
// the map.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACK_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACK_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/packing/pack.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Packs the charts of a mesh, and writes their coordinates if that succeeds.
template <typename TriangleMesh, typename FaceChartMap, typename HalfedgeUVMap, typename NamedParameters>
class Chart_packer
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename GetVertexPointMap<TriangleMesh, NamedParameters>::const_type Vertex_point_map;
  typedef typename boost::property_traits<FaceChartMap>::value_type Chart_number;
  typedef typename boost::property_traits<HalfedgeUVMap>::value_type Point_2;
  typedef Mesh_report<TriangleMesh, Packing_report> Report;

public:
  Chart_packer(const TriangleMesh& mesh, FaceChartMap chart_map, HalfedgeUVMap uv,
               const Packing_options& options, const NamedParameters& np)
      : m_mesh(mesh), m_chart_map(chart_map), m_uv(uv), m_options(options), m_np(np),
        m_points(parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                              get_const_property_map(CGAL::vertex_point, mesh)))
  {}

  Report run()
  {
    if(const std::string wrong = wrong_option(m_options); !wrong.empty())
      fail(Diagnosis::WRONG_OPTION, wrong);
    else if(read_charts() && read_areas() && read_coordinates())
      pack_and_write();
    return m_report;
  }

private:
  std::array<halfedge_descriptor, 3> halfedges_of(face_descriptor f) const
  {
    const halfedge_descriptor h = halfedge(f, m_mesh), g = next(h, m_mesh);
    return {h, g, next(g, m_mesh)};
  }

  bool fail(Diagnosis diagnosis, const std::string& message)
  {
    m_report.status = diagnosis;
    m_report.message = message;
    return false;
  }

  bool fail_at(face_descriptor f, Diagnosis diagnosis, const std::string& message)
  {
    m_report.offending_faces = {f};
    return fail(diagnosis, face_text(f) + message);
  }

  bool fail_in_chart(int chart, Diagnosis diagnosis, const std::string& message)
  {
    for(std::size_t t = 0; t < m_faces.size(); ++t)
      if(m_chart[t] == chart)
        m_report.offending_faces.push_back(m_faces[t]);
    return fail(diagnosis, "chart " + std::to_string(m_numbers[chart]) + message);
  }

  std::string face_text(face_descriptor f) const
  {
    return internal::face_text(f, m_mesh, m_points, vertex_numbers(m_mesh, m_np));
  }

  // Charts get numbers from 0 on, in the order of their own numbers.
  bool read_charts()
  {
    for(const face_descriptor f : faces(m_mesh)) {
      const Chart_number number = get(m_chart_map, f);
      if(number < Chart_number())
        continue;
      const std::array<halfedge_descriptor, 3> h = halfedges_of(f);
      if(next(h[2], m_mesh) != h[0])
        return fail_at(f, Diagnosis::NOT_TRIANGULATED, " is not a triangle");
      if(m_faces.size() == static_cast<std::size_t>(largest_number_of_triangles))
        return fail(Diagnosis::TOO_LARGE, "the charts have more triangles than 32-bit numbers allow");
      m_faces.push_back(f);
      m_numbers.push_back(number);
    }
    if(m_faces.empty())
      return fail(Diagnosis::EMPTY_MESH, "no face has a chart");
    std::sort(m_numbers.begin(), m_numbers.end());
    m_numbers.erase(std::unique(m_numbers.begin(), m_numbers.end()), m_numbers.end());
    for(const face_descriptor f : m_faces)
      m_chart.push_back(static_cast<int>(
          std::lower_bound(m_numbers.begin(), m_numbers.end(), get(m_chart_map, f)) - m_numbers.begin()));
    m_report.number_of_faces = m_faces.size();
    m_report.number_of_charts = m_numbers.size();
    return true;
  }

  double weight(face_descriptor f) const
  {
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::face_size_map_t>::value) {
      (void)f;
      return 1;
    } else
      return static_cast<double>(get(parameters::get_parameter(m_np, internal_np::face_size_map), f));
  }

  // Areas in space times squared weights, both divided by powers of two, so that nothing overflows
  bool read_areas()
  {
    double largest_coordinate = 0, largest_weight = 0;
    for(const face_descriptor f : m_faces) {
      for(const halfedge_descriptor h : halfedges_of(f))
        for(const double x : coordinates(h)) {
          if(!std::isfinite(x)) {
            m_report.offending_vertices = {target(h, m_mesh)};
            m_report.offending_faces = {f};
            return fail(Diagnosis::NON_FINITE_POINT,
                        vertex_text(vertex_numbers(m_mesh, m_np)(target(h, m_mesh)),
                                    get(m_points, target(h, m_mesh))) +
                            non_finite_text);
          }
          largest_coordinate = (std::max)(largest_coordinate, std::abs(x));
        }
      const double w = weight(f);
      if(!(w >= 0) || !std::isfinite(w))
        return fail_at(f, Diagnosis::WRONG_WEIGHT,
                       " has the weight " + std::to_string(w) +
                           ", and weights must be finite and not negative");
      largest_weight = (std::max)(largest_weight, w);
    }
    m_scale = power_of_two(largest_coordinate);
    m_weight_scale = power_of_two(largest_weight);
    for(const face_descriptor f : m_faces) {
      std::array<Chart::Point_3, 3> p;
      int k = 0;
      for(const halfedge_descriptor h : halfedges_of(f)) {
        const std::array<double, 3> x = coordinates(h);
        p[k++] = Chart::Point_3(x[0] / m_scale, x[1] / m_scale, x[2] / m_scale);
      }
      const double w = weight(f) / m_weight_scale;
      m_area.push_back(w * w * std::sqrt(CGAL::cross_product(p[1] - p[0], p[2] - p[0]).squared_length()) / 2);
    }
    return true;
  }

  std::array<double, 3> coordinates(halfedge_descriptor h) const
  {
    const auto& p = get(m_points, target(h, m_mesh));
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  bool read_coordinates()
  {
    for(const face_descriptor f : m_faces)
      for(const halfedge_descriptor h : halfedges_of(f)) {
        const auto& p = get(m_uv, h);
        m_corners.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
        if(!m_corners.back().allFinite())
          return fail_at(f, Diagnosis::NON_FINITE_COORDINATE,
                         " has coordinates in the plane that are not all finite numbers");
      }
    return true;
  }

  void pack_and_write()
  {
    Packing_options options = m_options; // for the areas as they are read
    options.texels_per_unit *= m_scale * m_weight_scale;
    const Packing packing = pack(m_corners, m_chart, m_area, static_cast<int>(m_numbers.size()), options);
    if(packing.status != Packing::DONE) {
      explain_failure(packing);
      return;
    }
    const std::vector<Point_2> placed = place(packing);
    if(m_report.status != Diagnosis::NOTHING_WRONG)
      return;
    std::size_t c = 0;
    for(const face_descriptor f : m_faces)
      for(const halfedge_descriptor h : halfedges_of(f))
        put(m_uv, h, placed[c++]);
    m_report.page_of_chart = packing.page;
    m_report.scale_of_chart = packing.scale;
    m_report.number_of_pages = static_cast<std::size_t>(packing.number_of_pages);
    m_report.covered_share = packing.covered_share;
    m_report.texels_per_length = packing.texels_per_length / m_scale / m_weight_scale;
    m_report.number_of_turned_charts = packing.number_of_turned;
    m_report.number_of_small_charts = packing.number_of_small;
    m_report.number_of_enlarged_charts = packing.number_of_enlarged;
    m_report.number_of_attempts = packing.number_of_attempts;
  }

  // The new coordinates as points of the map, certified
  std::vector<Point_2> place(const Packing& packing)
  {
    std::vector<Point_2> placed;
    placed.reserve(m_corners.size());
    for(std::size_t c = 0; c < m_corners.size(); ++c)
      m_corners[c] = packing.placement[m_chart[c / 3]](m_corners[c]);
    if(m_options.quantization_bits)
      quantize();
    for(const Planar_point& p : m_corners)
      placed.push_back(planar_point<Point_2>(Chart::Point_2(p.x(), p.y())));
    for(std::size_t c = 0; c < m_corners.size(); ++c)
      m_corners[c] = Planar_point(CGAL::to_double(placed[c].x()), CGAL::to_double(placed[c].y()));
    const Packing_check check = certify_packing(m_corners, m_chart, packing.page, m_options);
    if(check.status != Packing_check::CERTIFIED)
      fail_at(m_faces[check.triangle], Diagnosis::NOT_CERTIFIED,
              check.status == Packing_check::OUTSIDE ? " is not certified to be in its page"
                                                     : " is not certified to be apart from other charts");
    return placed;
  }

  // Corners of a chart at one vertex with the same coordinates move together.
  void quantize()
  {
    std::map<std::tuple<int, vertex_descriptor, double, double>, int> numbers;
    std::vector<int> vertex;
    std::vector<Chart::Point_2> uv;
    for(std::size_t t = 0; t < m_faces.size(); ++t)
      for(const halfedge_descriptor h : halfedges_of(m_faces[t])) {
        const Planar_point& p = m_corners[vertex.size()];
        const int next = static_cast<int>(uv.size());
        vertex.push_back(
            numbers.try_emplace({m_chart[t], target(h, m_mesh), p.x(), p.y()}, next).first->second);
        if(vertex.back() == next)
          uv.emplace_back(p.x(), p.y());
      }
    internal::quantize(vertex, *m_options.quantization_bits, uv);
    for(std::size_t c = 0; c < vertex.size(); ++c)
      m_corners[c] = Planar_point(uv[vertex[c]].x(), uv[vertex[c]].y());
    const Quantization_grid grid(*m_options.quantization_bits);
    std::size_t position = 0, t = 0; // of all faces, and of those that have a chart
    for(const face_descriptor f : faces(m_mesh)) {
      if(t < m_faces.size() && m_faces[t] == f) {
        const auto corner = m_corners.begin() + static_cast<std::ptrdiff_t>(3 * t++);
        if(!std::all_of(corner, corner + 3, [&grid](const Planar_point& p) { return grid.has(p); }))
          m_report.faces_off_grid.push_back(position);
      }
      ++position;
    }
  }

  void explain_failure(const Packing& packing)
  {
    if(packing.status == Packing::DEGENERATE_CHART)
      fail_in_chart(packing.chart, Diagnosis::DEGENERATE_CHART,
                    " has no area in the plane, or one that is too large to be computed");
    else if(packing.status == Packing::NON_FINITE)
      fail_in_chart(packing.chart, Diagnosis::NON_FINITE_COORDINATE, " has coordinates that are too large");
    else if(packing.status == Packing::NO_AREA)
      fail(Diagnosis::NO_AREA, "no face has both an area in space and a weight above 0");
    else if(packing.status == Packing::CHART_TOO_LARGE)
      fail_in_chart(packing.chart, Diagnosis::CHART_TOO_LARGE, too_large_text(packing, m_options));
    else if(packing.status == Packing::TOO_MANY_PAGES)
      fail(Diagnosis::TOO_MANY_PAGES, too_many_pages_text(packing, m_options));
    else
      fail(Diagnosis::TOO_MANY_CHARTS, std::to_string(m_numbers.size()) + " charts with " +
                                           std::to_string(m_options.number_of_gutter_texels()) +
                                           " texels between them do not fit into a page of " +
                                           page_text(m_options));
  }

  const TriangleMesh& m_mesh;
  FaceChartMap m_chart_map;
  HalfedgeUVMap m_uv;
  const Packing_options m_options;
  const NamedParameters& m_np;
  Vertex_point_map m_points;
  Report m_report;
  std::vector<face_descriptor> m_faces; // that have a chart
  std::vector<Chart_number> m_numbers;  // of each chart in the map
  std::vector<int> m_chart;             // of each face
  std::vector<double> m_area;           // the same
  std::vector<Planar_point> m_corners;
  double m_scale = 1, m_weight_scale = 1;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACK_MESH_H
