// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh as arrays of points and triangles in its own order, for what needs no connectivity.
// `seam_weights.h` reads the mesh with it, and `visibility.h` shoots its rays at it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_TRIANGLE_ARRAYS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_TRIANGLE_ARRAYS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

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
};

// Reads the points of a mesh, and numbers vertices and faces.
template <typename TriangleMesh, typename VertexPointMap, typename VertexNumberMap, typename FaceNumberMap>
Triangle_arrays read_triangles(const TriangleMesh& mesh, VertexPointMap points,
                               VertexNumberMap vertex_numbers, FaceNumberMap face_numbers)
{
  Triangle_arrays result;
  for(auto v : vertices(mesh)) {
    const auto& p = get(points, v);
    result.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    const std::size_t number = result.points.size() - 1;
    put(vertex_numbers, v, number);
    for(int i = 0; i < 3; ++i)
      if(!std::isfinite(result.points.back()[i]))
        throw std::invalid_argument("vertex " + std::to_string(number) +
                                    " has a coordinate that is not finite");
  }
  for(auto f : faces(mesh)) {
    const std::size_t number = result.triangles.size();
    put(face_numbers, f, number);
    if(!CGAL::is_triangle(halfedge(f, mesh), mesh))
      throw std::invalid_argument("face " + std::to_string(number) + " is not a triangle");
    result.triangles.emplace_back();
    auto h = halfedge(f, mesh);
    for(std::size_t& v : result.triangles.back()) {
      v = get(vertex_numbers, target(h, mesh));
      h = next(h, mesh);
    }
  }
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_TRIANGLE_ARRAYS_H
