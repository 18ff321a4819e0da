// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_FIT_RECTANGLE_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_FIT_RECTANGLE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/named_parameters.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

/// \ingroup PkgAngleBasedFlatteningRef
///
/// What `fit_rectangle()` returns.
///
/// \tparam TriangleMesh a model of `FaceGraph`
template <typename TriangleMesh>
struct Rectangle_fit_report : Mesh_report<TriangleMesh>
{
  /// The ratio of the sides before
  double ratio = 0;
  /// By how much the angles in the plane changed, in radians: the mean of all corners of all triangles
  double mean_angle_change = 0;
  /// The largest of these changes. It is at most \f$2\arcsin(|s - 1| / (s + 1))\f$ if the ratio changed by the factor
  /// \f$s\f$, up to the rounding of very short edges.
  double largest_angle_change = 0;
};

#ifndef DOXYGEN_RUNNING
namespace internal::ABF {

// A map of a chart to a rectangle, in coordinates from 0 to 1 along its sides
class Unit_rectangle
{
public:
  Unit_rectangle(const Chart& chart, std::vector<Planar_point> uv, const std::array<int, 4>& corners)
      : m_chart(chart), m_uv(std::move(uv)), m_corners(corners)
  {
    const Planar_point origin = m_uv[corners[0]], side = m_uv[corners[1]] - origin;
    width = side.norm();
    height = (m_uv[corners[3]] - origin).norm();
    const Planar_point x = side / width, y(-x.y(), x.x());
    for(Planar_point& p : m_uv)
      p = Planar_point((p - origin).dot(x) / width, (p - origin).dot(y) / height);
  }

  // Moves the vertices of the border exactly to the sides. Says which of them is too far away.
  Chart_defect straighten()
  {
    const double tolerance = 1e-6;
    const std::vector<int>& border = m_chart.borders.front();
    const auto is_corner = [&](int c, int i) { return m_chart.edge_source(c) == m_corners[i]; };
    auto c = std::find_if(border.begin(), border.end(), [&](int corner) { return is_corner(corner, 0); });
    int side = -1;
    for(std::size_t step = 0; step < border.size(); ++step) {
      const int v = m_chart.edge_source(*c);
      const bool is_next = side < 3 && is_corner(*c, side + 1);
      if(!is_next && std::find(m_corners.begin(), m_corners.end(), v) != m_corners.end())
        return {Diagnosis::WRONG_OPTION,
                vertex_text(m_chart, v) + " comes too early among the corners: they are not counterclockwise",
                {v},
                {}};
      side += is_next ? 1 : 0;
      Planar_point p = m_uv[v];
      p[(side + 1) % 2] = side == 1 || side == 2 ? 1 : 0;
      if(is_next)
        p = Planar_point(side == 1 || side == 2 ? 1 : 0, side >= 2 ? 1 : 0);
      if(!((p - m_uv[v]).norm() <= tolerance))
        return {Diagnosis::WRONG_OPTION,
                vertex_text(m_chart, v) +
                    " is on the border, and not on a side of a rectangle with these corners",
                {v},
                {}};
      m_uv[v] = p;
      if(++c == border.end())
        c = border.begin();
    }
    return {};
  }

  std::vector<Planar_point> scaled(double x, double y) const
  {
    std::vector<Planar_point> result;
    for(const Planar_point& p : m_uv)
      result.emplace_back(p.x() * x, p.y() * y);
    return result;
  }

  double width, height;

private:
  const Chart& m_chart;
  std::vector<Planar_point> m_uv;
  const std::array<int, 4> m_corners;
};

inline std::array<double, 3> angles_of_triangle(const Chart& chart, const std::vector<Planar_point>& uv,
                                                std::size_t t)
{
  return planar_angles(
      Planar_triangle{uv[chart.vertex[3 * t]], uv[chart.vertex[3 * t + 1]], uv[chart.vertex[3 * t + 2]]});
}

} // namespace internal::ABF
#endif // DOXYGEN_RUNNING

/// \ingroup PkgAngleBasedFlatteningRef
///
/// gives a map to a rectangle a ratio of sides, exactly up to rounding, by scaling its two directions. No map between
/// two rectangles changes angles less at the worst (H. Gr&ouml;tzsch, 1928). The area stays. The first corner comes to
/// the origin, and the first side to the positive x-axis. Border vertices are exactly on the sides. The time is linear.
///
/// \tparam TriangleMesh a model of `FaceGraph`
/// \tparam VertexUVMap a model of `ReadWritePropertyMap` with
///         `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and a two-dimensional point as value type
///
/// \param mesh a triangle mesh
/// \param uvmap the map of the connected component of the corners, to a rectangle with these corners, as
///   `parameterize()` makes it with the angles of `rectangle_angles()`
/// \param corners the corners, counterclockwise in the plane, as in `Rectangle_report::corners`
/// \param aspect_ratio the length of the side from the first corner to the second one, divided by that of the next side
///
/// \return what it costs in angles, or what is wrong, and then the map stays as it was: the ratio is not positive and
///   finite, the corners are not counterclockwise, or a border vertex is not on a side (`Diagnosis::WRONG_OPTION`); a
///   corner is not on the border of the first one (`Diagnosis::NOT_ON_BORDER`); or triangles are flipped
///   (`Diagnosis::FLIPPED_TRIANGLES`), or would be with coordinates of this number type
///   (`Diagnosis::PRECISION_EXCEEDED`). The report has the vertex or the triangles.
template <typename TriangleMesh, typename VertexUVMap>
Rectangle_fit_report<TriangleMesh>
fit_rectangle(const TriangleMesh& mesh, VertexUVMap uvmap,
              const std::array<typename boost::graph_traits<TriangleMesh>::vertex_descriptor, 4>& corners,
              double aspect_ratio)
{
  using namespace internal::ABF;
  typedef typename boost::property_traits<VertexUVMap>::value_type Point;
  Check_vertex_map<TriangleMesh, VertexUVMap>();
  Rectangle_fit_report<TriangleMesh> report;
  Chart_reader<TriangleMesh> reader(mesh);
  const auto fail = [&](const Chart_defect& defect) {
    report_defect(defect, reader, report);
    return report;
  };
  if(!(aspect_ratio > 0 && std::isfinite(aspect_ratio)))
    return fail({Diagnosis::WRONG_OPTION,
                 "the ratio of the sides of a rectangle must be positive and finite",
                 {},
                 {}});
  auto bhd = boost::graph_traits<TriangleMesh>::null_halfedge();
  for(auto h : CGAL::halfedges_around_target(corners[0], mesh))
    if(CGAL::is_border(h, mesh))
      bhd = h;
  if(const Chart_defect defect = reader.read(bhd))
    return fail(defect);
  std::array<int, 4> found;
  for(int i = 0; i < 4; ++i) {
    const std::vector<int>& border = reader.chart.borders.front();
    const auto c = std::find_if(border.begin(), border.end(), [&](int corner) {
      return reader.vertex_descriptors[reader.chart.edge_source(corner)] == corners[i];
    });
    if(c == border.end()) {
      fail({Diagnosis::NOT_ON_BORDER,
            vertex_of_mesh_text(mesh, corners[i]) + " is a corner, and is not on the border of the first one",
            {},
            {}});
      report.offending_vertices = {corners[i]};
      return report;
    }
    found[i] = reader.chart.edge_source(*c);
  }
  std::vector<Planar_point> uv;
  for(const auto& v : reader.vertex_descriptors)
    uv.emplace_back(CGAL::to_double(get(uvmap, v).x()), CGAL::to_double(get(uvmap, v).y()));
  const auto flipped = [&](const std::vector<Planar_point>& map) {
    std::vector<Chart::Point_2> points;
    for(const Planar_point& p : map)
      points.emplace_back(p.x(), p.y());
    return flipped_triangles(reader.chart, points);
  };
  if(const std::vector<int> triangles = flipped(uv); !triangles.empty())
    return fail({Diagnosis::FLIPPED_TRIANGLES, "the map has flipped triangles", {}, triangles});
  Unit_rectangle unit(reader.chart, uv, found);
  if(const Chart_defect defect = unit.straighten())
    return fail(defect);

  const double height = std::sqrt(unit.width * unit.height / aspect_ratio);
  std::vector<Point> result;
  std::vector<Planar_point> fitted = unit.scaled(height * aspect_ratio, height);
  for(Planar_point& p : fitted) {
    result.emplace_back(p.x(), p.y());
    p = Planar_point(CGAL::to_double(result.back().x()), CGAL::to_double(result.back().y()));
  }
  if(const std::vector<int> triangles = flipped(fitted); !triangles.empty())
    return fail({Diagnosis::PRECISION_EXCEEDED, "triangles would be flipped by rounding", {}, triangles});
  for(std::size_t t = 0; t < reader.chart.vertex.size() / 3; ++t) {
    const std::array<double, 3> before = angles_of_triangle(reader.chart, uv, t),
                                after = angles_of_triangle(reader.chart, fitted, t);
    for(int i = 0; i < 3; ++i) {
      report.mean_angle_change += std::abs(after[i] - before[i]);
      report.largest_angle_change = (std::max)(report.largest_angle_change, std::abs(after[i] - before[i]));
    }
  }
  report.mean_angle_change /= static_cast<double>(reader.chart.vertex.size());
  report.ratio = unit.width / unit.height;
  for(std::size_t v = 0; v < result.size(); ++v)
    put(uvmap, reader.vertex_descriptors[v], result[v]);
  return report;
}

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_FIT_RECTANGLE_H
