// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From a mesh of any topology to connected parts as flat arrays, with costs of edges, and back from corners to
// halfedges. `apply_seams.h`, `overlaps/split_charts.h`, `cones/` and `atlas/` read with it. `chart/read_chart.h` does
// this for a single disk.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_SURFACE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_SURFACE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/face_search.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A connected part of a surface, and what its edges cost
struct Surface_part
{
  Chart chart;
  int first_triangle = 0;                // among those of the whole surface
  std::vector<double> cost;              // of the edge that each corner faces
  std::vector<char> is_diagonal;         // the same edge, in a larger polygon; empty if there are none
  std::vector<Chart::Point_2> given_map; // of each vertex of the chart; empty if none is to be kept
};

// Reads a mesh of any topology as connected parts, and writes seams to it. A vertex whose triangles do not all hang
// together by edges becomes several ones. `Report` has a diagnosis for each error, and a message.
template <typename TriangleMesh, typename VertexPointMap, typename Report>
class Surface_reader
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;

public:
  // Messages number vertices by positions, or by `numbers`.
  Surface_reader(const TriangleMesh& mesh, VertexPointMap points, Vertex_numbers<TriangleMesh> numbers = {})
      : m_mesh(mesh), m_points(points), m_numbers(numbers ? std::move(numbers) : vertex_positions(mesh)),
        m_faces(mesh)
  {}

  const std::vector<Surface_part>& parts() const { return m_parts; }
  std::vector<Surface_part>& parts() { return m_parts; }
  double scale() const { return m_scale; } // lengths in the mesh, divided by those of the parts

  // Reads the surface, opened along the edges with `is_cut(e)`. Returns whether that is possible, and says why if it is
  // not.
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
    if(!read_unscaled(is_cut, is_skipped, report))
      return false;
    set_scale(power_of_two(m_largest));
    return true;
  }

  // The same in two steps, for several meshes with the same scale: first without it
  template <typename IsCut, typename IsSkipped>
  bool read_unscaled(const IsCut& is_cut, const IsSkipped& is_skipped, Report& report)
  {
    return find_faces(is_cut, is_skipped, report) && read_points(report);
  }

  double largest_coordinate() const { return m_largest; }

  void set_scale(double scale)
  {
    m_scale = scale;
    for(Surface_part& part : m_parts) {
      ABF::set_scale(scale, part.chart);
      find_borders(part.chart);
    }
  }

  face_descriptor face_of(int triangle) const { return m_faces.face_of(triangle); }

  // Its number, or -1 if it was not read
  int triangle_of(face_descriptor f) const { return m_faces.rank(f); }

  std::size_t part_of(int triangle) const
  {
    const auto next =
        std::upper_bound(m_parts.begin(), m_parts.end(), triangle,
                         [](int t, const Surface_part& part) { return t < part.first_triangle; });
    return static_cast<std::size_t>(next - m_parts.begin()) - 1;
  }

  // The one to a corner of the surface, in its face
  halfedge_descriptor halfedge_to(int corner) const { return m_faces.halfedge_to(corner); }

  // The vertex of the mesh that a vertex of a part is. Searches for it.
  vertex_descriptor vertex_of(const Surface_part& part, int v) const
  {
    const std::vector<int>& vertex = part.chart.vertex;
    const auto corner = std::find(vertex.begin(), vertex.end(), v) - vertex.begin();
    return target(halfedge_to(3 * part.first_triangle + static_cast<int>(corner)), m_mesh);
  }

  // The edge that a corner of the surface faces
  edge_descriptor edge_of(int corner) const { return edge(m_faces.faced_halfedge(corner), m_mesh); }

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
          report.offending_edges = {edge_of(3 * part.first_triangle + c)};
          fail(report, Diagnosis::WRONG_WEIGHT,
               "the edge from " + vertex_text(chart, chart.edge_source(c)) + " to " +
                   vertex_text(chart, chart.edge_target(c)) + " has the weight " +
                   std::to_string(part.cost[c]) + ", and weights must not be negative");
          return false;
        }
      }
    }
    return true;
  }

  // Sets which edges divide polygons into triangles.
  template <typename IsDiagonal>
  void read_diagonals(const IsDiagonal& is_diagonal)
  {
    for(Surface_part& part : m_parts) {
      for(int c = 0; c < part.chart.number_of_corners(); ++c)
        part.is_diagonal.push_back(is_diagonal(edge_of(3 * part.first_triangle + c)));
      if(std::find(part.is_diagonal.begin(), part.is_diagonal.end(), true) == part.is_diagonal.end())
        part.is_diagonal.clear();
    }
  }

  // Sets the maps that parts have: `uv_of(h)` is that of the halfedge's target in its face.
  template <typename UvOf>
  void read_given_maps(const UvOf& uv_of)
  {
    for(Surface_part& part : m_parts) {
      part.given_map.resize(part.chart.points.size());
      for(int c = 0; c < part.chart.number_of_corners(); ++c)
        part.given_map[part.chart.vertex[c]] = uv_of(halfedge_to(3 * part.first_triangle + c));
    }
  }

  // The number of connected components of the surface that was read, if it were not opened
  std::size_t count_components() const
  {
    Disjoint_sets sets(m_parts.size());
    std::size_t count = m_parts.size();
    for(std::size_t i = 0; i < m_parts.size(); ++i)
      for(int c = 0; c < m_parts[i].chart.number_of_corners(); ++c) {
        if(m_parts[i].chart.opposite[c] >= 0)
          continue;
        const halfedge_descriptor across =
            opposite(m_faces.faced_halfedge(3 * m_parts[i].first_triangle + c), m_mesh);
        if(CGAL::is_border(across, m_mesh))
          continue;
        const std::size_t j = part_of(m_faces.rank(face(across, m_mesh)));
        if(sets.find_set(i) != sets.find_set(j)) {
          sets.union_set(i, j);
          --count;
        }
      }
    return count;
  }

  static void fail(Report& report, Diagnosis diagnosis, const std::string& message)
  {
    report.status = diagnosis;
    report.message = message;
  }

private:
  // Faces come in the order of a breadth-first search, part by part.
  template <typename IsCut, typename IsSkipped>
  bool find_faces(const IsCut& is_cut, const IsSkipped& is_skipped, Report& report)
  {
    m_faces.begin();
    for(face_descriptor f : faces(m_mesh)) {
      if(m_faces.rank(f) >= 0 || is_skipped(f))
        continue;
      m_parts.emplace_back();
      m_parts.back().first_triangle = m_faces.size();
      const Chart_defect defect = m_faces.find_part(
          halfedge(f, m_mesh), is_cut, [](int) {}, [](int) {}, m_parts.back().chart);
      if(defect) {
        fail(report, defect.status, defect.message);
        for(int t : defect.triangles) { // one that is no triangle
          report.offending_faces = {face_of(t)};
          const vertex_descriptor v = target(m_faces.entry(t), m_mesh);
          report.message = "face " + rank_text(faces(m_mesh), face_of(t)) + ", at " +
                           vertex_text(m_numbers(v), get(m_points, v)) + ", is not a triangle";
        }
        return false;
      }
    }
    if(m_faces.size() == 0)
      fail(report, Diagnosis::EMPTY_MESH, "the mesh has no faces");
    return m_faces.size() > 0;
  }

  bool read_points(Report& report)
  {
    for(Surface_part& part : m_parts) {
      number_vertices(part);
      for(int v = 0; v < part.chart.number_of_vertices(); ++v)
        for(int i = 0; i < 3; ++i) {
          const Chart::Point_3& p = part.chart.points[v];
          m_largest = (std::max)(m_largest, std::abs(p[i]));
          if(!std::isfinite(p[i])) {
            report.offending_vertices = {vertex_of(part, v)};
            fail(report, Diagnosis::NON_FINITE_POINT, vertex_text(part.chart, v) + non_finite_text);
            return false;
          }
        }
    }
    return true;
  }

  // In the order in which the triangles come upon them
  void number_vertices(Surface_part& part) const
  {
    Chart& chart = part.chart;
    chart.vertex.assign(chart.opposite.size(), -1);
    for(int corner = 0; corner < chart.number_of_corners(); ++corner) {
      if(chart.vertex[corner] >= 0)
        continue;
      set_vertex_around(corner, chart.number_of_vertices(), chart);
      const vertex_descriptor v = target(halfedge_to(3 * part.first_triangle + corner), m_mesh);
      chart.points.push_back(point_in_doubles(get(m_points, v)));
      chart.numbers.push_back(m_numbers(v));
    }
  }

  // Clockwise, and counterclockwise as well where the triangles do not close around the vertex
  static void set_vertex_around(int corner, int v, Chart& chart)
  {
    for(int c = corner; c >= 0 && chart.vertex[c] < 0; c = chart.rotate(c))
      chart.vertex[c] = v;
    for(int across = chart.opposite[next_corner(corner)];
        across >= 0 && chart.vertex[next_corner(across)] < 0;
        across = chart.opposite[next_corner(next_corner(across))])
      chart.vertex[next_corner(across)] = v;
  }

  const TriangleMesh& m_mesh;
  VertexPointMap m_points;
  Vertex_numbers<TriangleMesh> m_numbers;
  Face_search<TriangleMesh> m_faces;
  std::vector<Surface_part> m_parts;
  double m_largest = 0; // of the absolute values of coordinates
  double m_scale = 1;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_READ_SURFACE_H
