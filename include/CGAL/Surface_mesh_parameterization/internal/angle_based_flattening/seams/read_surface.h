// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_READ_SURFACE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_READ_SURFACE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A connected part of a surface, and what its edges cost
struct Surface_part
{
  Chart chart;
  int first_triangle = 0;   // among those of the whole surface
  std::vector<double> cost; // of the edge that each corner faces
};

// Reads a mesh of any topology as connected parts, and writes seams to it. A vertex whose triangles do not all hang together by edges
// becomes several ones. `Report` has a diagnosis for each error, and a message.
template <typename TriangleMesh, typename VertexPointMap, typename Report>
class Surface_reader
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

public:
  Surface_reader(const TriangleMesh& mesh, VertexPointMap points) : m_mesh(mesh), m_points(points) {}

  const std::vector<Surface_part>& parts() const { return m_parts; }
  double scale() const { return m_scale; } // lengths in the mesh, divided by those of the parts

  // Reads the surface, opened along the edges with `is_cut(e)`. Returns whether that is possible, and says why if it is not.
  template <typename IsCut>
  bool read(const IsCut& is_cut, Report& report)
  {
    return read(
        is_cut, [](face_descriptor) { return false; }, report);
  }

  // The same without the faces with `is_skipped(f)`, which are whole components of the opened mesh
  template <typename IsCut, typename IsSkipped>
  bool read(const IsCut& is_cut, const IsSkipped& is_skipped, Report& report)
  {
    return find_faces(is_cut, is_skipped, report) && read_points(report);
  }

  face_descriptor face_of(int triangle) const { return m_faces[triangle]; }

  // The one to a corner of the surface, in its face: corner k of a face is at the target of its halfedge number k.
  halfedge_descriptor halfedge_to(int corner) const
  {
    halfedge_descriptor h = halfedge(m_faces[corner / 3], m_mesh);
    for(int k = corner % 3; k > 0; --k)
      h = next(h, m_mesh);
    return h;
  }

  // The edge that a corner of the surface faces
  edge_descriptor edge_of(int corner) const { return edge(halfedge_to(previous_corner(corner)), m_mesh); }

  // Sets what edges cost: `cost_of(e, length)`, where the length is that in the parts.
  template <typename Cost>
  bool read_costs(const Cost& cost_of, Report& report)
  {
    for(Surface_part& part : m_parts) {
      const Chart& chart = part.chart;
      part.cost.resize(chart.vertex.size());
      for(int c = 0; c < chart.number_of_corners(); ++c) {
        if(const int across = chart.opposite[c]; across >= 0 && across < c) {
          part.cost[c] = part.cost[across];
          continue;
        }
        part.cost[c] = cost_of(edge_of(3 * part.first_triangle + c), edge_length(chart, c));
        if(!(part.cost[c] >= 0)) {
          fail(report, Report::WRONG_WEIGHT,
               "the edge from " + position_text(chart, chart.edge_source(c)) + " to " +
                   position_text(chart, chart.edge_target(c)) + " has the weight " +
                   std::to_string(part.cost[c]) + ", and weights must not be negative");
          return false;
        }
      }
    }
    return true;
  }

  // The number of connected parts of the whole surface, opened along the edges with `is_cut(e)`
  template <typename IsCut>
  std::size_t count_parts(const IsCut& is_cut) const
  {
    Disjoint_sets sets(m_faces.size());
    std::size_t count = m_faces.size();
    for(std::size_t t = 0; t < m_faces.size(); ++t)
      for(const halfedge_descriptor h : halfedges_around_face(halfedge(m_faces[t], m_mesh), m_mesh))
        if(const halfedge_descriptor across = opposite(h, m_mesh);
           !CGAL::is_border(across, m_mesh) && !is_cut(edge(h, m_mesh))) {
          const auto other = static_cast<std::size_t>(get(m_ranks, face(across, m_mesh)));
          if(sets.find_set(t) != sets.find_set(other)) {
            sets.union_set(t, other);
            --count;
          }
        }
    return count;
  }

  static void fail(Report& report, typename Report::Diagnosis diagnosis, const std::string& message)
  {
    report.diagnosis = diagnosis;
    report.message = message;
  }

private:
  // Faces come in the order of a breadth-first search, part by part.
  template <typename IsCut, typename IsSkipped>
  bool find_faces(const IsCut& is_cut, const IsSkipped& is_skipped, Report& report)
  {
    m_ranks = get(CGAL::dynamic_face_property_t<int>(), m_mesh);
    for(face_descriptor f : faces(m_mesh))
      put(m_ranks, f, -1);
    for(face_descriptor f : faces(m_mesh)) {
      if(get(m_ranks, f) >= 0 || is_skipped(f))
        continue;
      const std::size_t first = m_faces.size();
      find(f);
      for(std::size_t t = first; t < m_faces.size(); ++t) {
        halfedge_descriptor h = halfedge(m_faces[t], m_mesh);
        for(int k = 0; k < 3; ++k, h = next(h, m_mesh))
          if(const halfedge_descriptor across = opposite(h, m_mesh);
             !CGAL::is_border(across, m_mesh) && !is_cut(edge(h, m_mesh)))
            find(face(across, m_mesh));
        if(h != halfedge(m_faces[t], m_mesh)) {
          const auto p = get(m_points, target(h, m_mesh));
          fail(report, Report::NOT_TRIANGULATED, "the face at " + point_text(p) + " is not a triangle");
          return false;
        }
        if(m_faces.size() > static_cast<std::size_t>(largest_number_of_triangles)) {
          fail(report, Report::TOO_LARGE, "the surface has more triangles than 32-bit numbers allow");
          return false;
        }
      }
      m_parts.push_back(link(static_cast<int>(first), is_cut));
    }
    if(m_faces.empty())
      fail(report, Report::EMPTY_MESH, "the mesh has no faces");
    return !m_faces.empty();
  }

  void find(face_descriptor f)
  {
    if(get(m_ranks, f) >= 0)
      return;
    put(m_ranks, f, static_cast<int>(m_faces.size()));
    m_faces.push_back(f);
  }

  template <typename Point>
  static std::string point_text(const Point& p)
  {
    Chart chart;
    chart.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    return position_text(chart, 0);
  }

  template <typename IsCut>
  Surface_part link(int first, const IsCut& is_cut)
  {
    Surface_part part;
    part.first_triangle = first;
    Chart& chart = part.chart;
    chart.opposite.resize(3 * (m_faces.size() - first), -1);
    for(int t = 0; t < static_cast<int>(chart.opposite.size()) / 3; ++t) {
      halfedge_descriptor h = halfedge(m_faces[first + t], m_mesh);
      for(int k : {1, 2, 0}) {
        if(const int across = corner_across(h, first); across < 0 || !is_cut(edge(h, m_mesh)))
          chart.opposite[3 * t + k] = across;
        else
          set_seam(chart, 3 * t + k, across);
        h = next(h, m_mesh);
      }
    }
    return part;
  }

  // The corner in the part that began with triangle `first` which faces the same edge; -1 if there is none
  int corner_across(halfedge_descriptor h, int first) const
  {
    const halfedge_descriptor across = opposite(h, m_mesh);
    const bool is_in_part = !CGAL::is_border(across, m_mesh) && get(m_ranks, face(across, m_mesh)) >= first;
    return is_in_part ? facing_corner(across) - 3 * first : -1;
  }

  static void set_seam(Chart& chart, int c, int across)
  {
    chart.seam.resize(chart.opposite.size(), -1);
    chart.seam[c] = across;
  }

  int facing_corner(halfedge_descriptor h) const
  {
    const face_descriptor f = face(h, m_mesh);
    int k = 1;
    for(halfedge_descriptor g = halfedge(f, m_mesh); g != h; g = next(g, m_mesh))
      ++k;
    return 3 * get(m_ranks, f) + k % 3;
  }

  bool read_points(Report& report)
  {
    double largest = 0;
    for(Surface_part& part : m_parts) {
      number_vertices(part);
      for(const Chart::Point_3& p : part.chart.points)
        for(int i = 0; i < 3; ++i) {
          largest = (std::max)(largest, std::abs(p[i]));
          if(!std::isfinite(p[i])) {
            fail(report, Report::NON_FINITE_POINT,
                 "a vertex has coordinates " + point_text(p) + ", which are not all finite numbers");
            return false;
          }
        }
    }
    m_scale = power_of_two(largest);
    for(Surface_part& part : m_parts) {
      part.chart.scale = m_scale;
      for(Chart::Point_3& p : part.chart.points)
        p = Chart::Point_3(p.x() / m_scale, p.y() / m_scale, p.z() / m_scale);
      find_borders(part.chart);
    }
    return true;
  }

  // In the order in which the triangles come upon them
  void number_vertices(Surface_part& part) const
  {
    Chart& chart = part.chart;
    chart.vertex.assign(chart.opposite.size(), -1);
    int corner = 0;
    for(int t = 0; t < chart.number_of_triangles(); ++t) {
      halfedge_descriptor h = halfedge(m_faces[part.first_triangle + t], m_mesh);
      for(int k = 0; k < 3; ++k, ++corner, h = next(h, m_mesh)) {
        if(chart.vertex[corner] >= 0)
          continue;
        const auto& p = get(m_points, target(h, m_mesh));
        for(int c : corners_around(chart, corner))
          chart.vertex[c] = chart.number_of_vertices();
        chart.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      }
    }
  }

  const TriangleMesh& m_mesh;
  VertexPointMap m_points;
  typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int>>::const_type m_ranks;
  std::vector<face_descriptor> m_faces;
  std::vector<Surface_part> m_parts;
  double m_scale = 1;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_READ_SURFACE_H
