// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How far vertices can be seen, by rays: the body of `visibility()`. `seam_weights.h` includes it, or the source file
// of the compiled library.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_VISIBILITY_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_VISIBILITY_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_objects.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_type_config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal {

inline constexpr int number_of_rays = 48;

// Fibonacci's lattice on the unit sphere
inline std::array<Seam_kernel::Vector_3, number_of_rays> ray_directions()
{
  std::array<Seam_kernel::Vector_3, number_of_rays> result;
  const double golden_angle = CGAL_PI * (3 - std::sqrt(5.));
  for(int i = 0; i < number_of_rays; ++i) {
    const double z = 1 - (2 * i + 1.) / number_of_rays, r = std::sqrt(1 - z * z);
    result[i] = Seam_kernel::Vector_3(r * std::cos(i * golden_angle), r * std::sin(i * golden_angle), z);
  }
  return result;
}

// The sum of the normals of the triangles at each vertex, weighted by area
inline std::vector<Seam_kernel::Vector_3> vertex_normals(const Triangle_arrays& mesh)
{
  std::vector<Seam_kernel::Vector_3> normals(mesh.points.size(), CGAL::NULL_VECTOR);
  for(const auto& [a, b, c] : mesh.triangles) {
    const Seam_kernel::Vector_3 normal = mesh.normal({a, b, c});
    for(std::size_t v : {a, b, c})
      normals[v] = normals[v] + normal;
  }
  return normals;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<double> visibility(const Triangle_arrays& mesh)
{
  const Nearest_objects<Seam_kernel::Triangle_3> triangles(mesh.proper_triangles());
  CGAL::Bbox_3 box;
  for(const Seam_kernel::Point_3& p : mesh.points)
    box += p.bbox();
  // The rays start a bit above the surface, so that they do not meet it there.
  const double distance =
      1e-6 * std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());

  const std::vector<Seam_kernel::Vector_3> normals = vertex_normals(mesh);
  const auto directions = ray_directions();
  std::vector<double> result(mesh.points.size(), 1);
  parallel_for_blocks(static_cast<int>(result.size()), [&](int begin, int end) {
    for(int v = begin; v < end; ++v) {
      const double length = std::sqrt(normals[v].squared_length());
      if(!(length > 0))
        continue;
      const Seam_kernel::Point_3 start = mesh.points[v] + normals[v] * (distance / length);
      int outward = 0, unobstructed = 0;
      for(const Seam_kernel::Vector_3& direction : directions)
        if(direction * normals[v] > 0) {
          ++outward;
          unobstructed += !triangles.is_met_by(Seam_kernel::Ray_3(start, direction));
        }
      result[v] = static_cast<double>(unobstructed) / outward;
    }
  });
  return result;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_VISIBILITY_IMPL_H
