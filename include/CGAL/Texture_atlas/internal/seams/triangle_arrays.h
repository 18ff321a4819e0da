// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh as arrays of points and triangles in its own order, for what needs no connectivity.
// `seam_weights.h` reads the mesh with it, and `visibility.h` shoots its rays at it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_TRIANGLE_ARRAYS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_TRIANGLE_ARRAYS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
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

  // Those that have an area
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
        report.message = "vertex " + std::to_string(number) + " has a coordinate that is not finite";
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

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_TRIANGLE_ARRAYS_H
