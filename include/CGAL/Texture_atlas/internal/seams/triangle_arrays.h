// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh as arrays of points and triangles in its own order, and as a graph of its edges, for what needs no corner
// table: `seam_weights.h`, which asks for the visibility of vertices, and `symmetrize_seams.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_TRIANGLE_ARRAYS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_TRIANGLE_ARRAYS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

typedef CGAL::Simple_cartesian<double> Seam_kernel;

// Points and triangles of a mesh in its order
struct Triangle_arrays
{
  std::vector<Seam_kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  // Twice as long as the area is large
  Seam_kernel::Vector_3 normal(const std::array<std::size_t, 3>& t) const
  {
    return CGAL::cross_product(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
  }

  // The triangles that have an area
  std::vector<Seam_kernel::Triangle_3> proper_triangles() const
  {
    std::vector<Seam_kernel::Triangle_3> result;
    for(const auto& t : triangles)
      if(normal(t) != CGAL::NULL_VECTOR)
        result.emplace_back(points[t[0]], points[t[1]], points[t[2]]);
    return result;
  }
};

// Reads the points of a mesh, and numbers vertices and faces. Returns whether that is possible, and says why if it is
// not.
template <typename TriangleMesh, typename VertexPointMap, typename VertexNumberMap, typename FaceNumberMap,
          typename Report>
bool read_triangles(const TriangleMesh& mesh, VertexPointMap points, VertexNumberMap vertex_numbers,
                    FaceNumberMap face_numbers, Triangle_arrays& arrays,
                    Mesh_report<TriangleMesh, Report>& report)
{
  for(auto v : vertices(mesh)) {
    const auto& p = get(points, v);
    arrays.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    const std::size_t number = arrays.points.size() - 1;
    put(vertex_numbers, v, number);
    for(int i = 0; i < 3; ++i)
      if(!std::isfinite(arrays.points.back()[i])) {
        report.status = Diagnosis::NON_FINITE_POINT;
        report.message =
            vertex_text(static_cast<std::ptrdiff_t>(number), arrays.points.back()) + non_finite_text;
        report.offending_vertices = {v};
        return false;
      }
  }
  for(auto f : faces(mesh)) {
    const std::size_t number = arrays.triangles.size();
    put(face_numbers, f, number);
    if(!CGAL::is_triangle(halfedge(f, mesh), mesh)) {
      report.status = Diagnosis::NOT_TRIANGULATED;
      report.message = "face " + std::to_string(number) + " is not a triangle";
      report.offending_faces = {f};
      return false;
    }
    arrays.triangles.emplace_back();
    auto h = halfedge(f, mesh);
    for(std::size_t& v : arrays.triangles.back()) {
      v = get(vertex_numbers, target(h, mesh));
      h = next(h, mesh);
    }
  }
  return true;
}

// The edges of a mesh, by the numbers of their ends, with the edges at each vertex
class Edge_graph
{
public:
  typedef std::array<std::size_t, 2> Ends;

  Edge_graph(const std::vector<Seam_kernel::Point_3>& vertex_points, std::vector<Ends> edge_ends)
      : points(vertex_points), ends(std::move(edge_ends)), m_first(points.size() + 1, 0),
        m_edges(2 * ends.size())
  {
    for(const Ends& e : ends)
      for(std::size_t v : e)
        ++m_first[v + 1];
    for(std::size_t v = 0; v < points.size(); ++v)
      m_first[v + 1] += m_first[v];
    std::vector<std::size_t> place(m_first.begin(), m_first.end() - 1);
    for(std::size_t e = 0; e < ends.size(); ++e)
      for(std::size_t v : ends[e])
        m_edges[place[v]++] = e;
  }

  std::size_t other_end(std::size_t e, std::size_t v) const
  {
    return ends[e][0] == v ? ends[e][1] : ends[e][0];
  }

  // The edge between two vertices that one joins
  std::size_t edge_between(std::size_t v, std::size_t w) const
  {
    std::size_t result = 0;
    for_edges_at(v, [&](std::size_t e) { result = other_end(e, v) == w ? e : result; });
    return result;
  }

  double length(std::size_t e) const
  {
    return std::sqrt(CGAL::squared_distance(points[ends[e][0]], points[ends[e][1]]));
  }

  template <typename Function>
  void for_edges_at(std::size_t v, const Function& f) const
  {
    for(std::size_t i = m_first[v]; i < m_first[v + 1]; ++i)
      f(m_edges[i]);
  }

  const std::vector<Seam_kernel::Point_3>& points;
  const std::vector<Ends> ends; // of each edge

private:
  std::vector<std::size_t> m_first; // place of each vertex in `m_edges`
  std::vector<std::size_t> m_edges;
};

// How far each vertex can be seen from outside: seams are better hidden, as Sheffer and Hart (2002) lay theirs. It is
// the share of the rays into the half space of its normal that leave without meeting a triangle; 1 for vertices without
// a normal.
CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<double> visibility(const Triangle_arrays& mesh);

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_TRIANGLE_ARRAYS_H
