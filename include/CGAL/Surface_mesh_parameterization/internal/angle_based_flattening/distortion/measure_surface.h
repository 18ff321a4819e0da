// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures a map of a whole surface, of any number of charts, at one scale. Called by `measure_flattening()`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_MEASURE_SURFACE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_MEASURE_SURFACE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/measure_chart.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The parts of a surface that its map cuts open, with their coordinates
template <typename TriangleMesh, typename VertexPointMap, typename UVMap>
class Mapped_surface
{
  typedef typename boost::graph_traits<TriangleMesh>::edge_descriptor edge_descriptor;
  typedef Flattening_measures_report<TriangleMesh> Report;

public:
  Mapped_surface(const TriangleMesh& mesh, VertexPointMap points, Vertex_numbers<TriangleMesh> numbers,
                 UVMap uvmap)
      : m_coordinates(mesh, uvmap), m_reader(mesh, points, std::move(numbers))
  {
    const auto is_cut = [&](edge_descriptor e) {
      return !CGAL::is_border(e, mesh) && m_coordinates.is_at_border(halfedge(e, mesh));
    };
    if(m_reader.read(is_cut, m_report))
      read_coordinates();
  }

  // Calls `visit(f, measures)` for each face, if the surface could be read.
  template <typename FaceVisitor>
  Report measure(FaceVisitor& visit) const
  {
    if(!m_report)
      return m_report;
    int triangles = 0;
    Total_areas areas;
    for(std::size_t i = 0; i < m_uv.size(); ++i) {
      const Total_areas part = total_areas(chart(i), m_uv[i]);
      triangles += chart(i).number_of_triangles();
      areas.surface += part.surface;
      areas.plane += part.plane;
    }
    Measure_totals totals(triangles, areas.surface);
    const double scale = std::sqrt(areas.surface / areas.plane);
    for(std::size_t i = 0; i < m_uv.size(); ++i) {
      const int first = m_reader.parts()[i].first_triangle;
      measure_triangles(chart(i), m_uv[i], scale, totals, [&](int t, const Flattening_face_measures& face) {
        visit(m_reader.face_of(first + t), face);
      });
    }
    Report report;
    static_cast<Flattening_measures&>(report) = totals.measures();
    report.border_is_simple = is_border_simple();
    return report;
  }

private:
  const Chart& chart(std::size_t i) const { return m_reader.parts()[i].chart; }

  // Divided by their largest absolute value: the measures do not depend on it.
  void read_coordinates()
  {
    double largest = 0;
    for(const Surface_part& part : m_reader.parts()) {
      std::vector<Chart::Point_2> uv(part.chart.points.size());
      for(int c = 0; c < part.chart.number_of_corners(); ++c) {
        const auto& p = m_coordinates[m_reader.halfedge_to(3 * part.first_triangle + c)];
        Chart::Point_2& q = uv[part.chart.vertex[c]];
        q = Chart::Point_2(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
        largest = (std::max)({largest, std::abs(q.x()), std::abs(q.y())});
      }
      m_uv.push_back(std::move(uv));
    }
    const double scale = power_of_two(largest);
    for(std::vector<Chart::Point_2>& uv : m_uv)
      for(Chart::Point_2& p : uv)
        p = Chart::Point_2(p.x() / scale, p.y() / scale);
  }

  // Of all parts together
  bool is_border_simple() const
  {
    std::vector<Border_edge> border;
    std::vector<Exact_point_2> points;
    for(std::size_t i = 0; i < m_uv.size(); ++i) {
      const int first = static_cast<int>(points.size());
      for(const Chart::Point_2& p : m_uv[i])
        points.push_back(exact_point(p));
      for(int c = 0; c < chart(i).number_of_corners(); ++c)
        if(chart(i).opposite[c] < 0)
          border.push_back({first + chart(i).edge_source(c), first + chart(i).edge_target(c)});
    }
    return bounds_region(border, points);
  }

  const Corner_coordinates<TriangleMesh, UVMap> m_coordinates;
  Surface_reader<TriangleMesh, VertexPointMap, Report> m_reader;
  Report m_report;                               // of reading
  std::vector<std::vector<Chart::Point_2>> m_uv; // of the vertices of each part
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_MEASURE_SURFACE_H
