// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Normals that tell creases, also beside needles. `crease_patches.h` compares them.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_CREASE_NORMALS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_CREASE_NORMALS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/flat_layout.h>

#include <CGAL/Origin.h>

#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Unit normals of triangles. The direction of a needle is mostly rounding: it takes the normal across its longest side.
inline std::vector<Corner_table::Kernel::Vector_3> crease_normals(const Corner_table& surface)
{
  const double least_height = 1e-4; // of the longest side
  std::vector<Corner_table::Kernel::Vector_3> normals;
  std::vector<int> needles; // the corners that face their longest sides
  for(int t = 0; t < surface.number_of_triangles(); ++t) {
    const auto normal = triangle_normal(surface, t);
    const double length = std::sqrt(normal.squared_length());
    int longest = 3 * t;
    for(int c : {3 * t + 1, 3 * t + 2})
      longest = edge_length(surface, c) > edge_length(surface, longest) ? c : longest;
    const double side = edge_length(surface, longest);
    const bool is_needle = !(length > least_height * side * side);
    normals.push_back(is_needle ? CGAL::NULL_VECTOR : normal / length);
    if(is_needle)
      needles.push_back(longest);
  }
  // twice, because needles come in pairs
  for(int round = 0; round < 2; ++round)
    for(int c : needles)
      if(normals[c / 3] == CGAL::NULL_VECTOR && surface.opposite[c] >= 0)
        normals[c / 3] = normals[surface.opposite[c] / 3];
  return normals;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_CREASE_NORMALS_H
