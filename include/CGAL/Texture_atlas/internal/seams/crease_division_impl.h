// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The body of `divide_at_creases()`. `crease_division.h` includes it; the compiled library has it in
// `angle_based_flattening_creases.cpp`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_DIVISION_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_DIVISION_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/seams/crease_division.h>
#include <CGAL/Texture_atlas/internal/seams/crease_patches.h>
#include <CGAL/Texture_atlas/internal/seams/merge_patches.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/patch_layouts.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The sum of what the angles lack or exceed 2 pi at vertices within patches
inline double curvature_within(const std::vector<int>& patch, const Chart& surface)
{
  std::vector<double> missing(surface.points.size(), 2 * pi);
  std::vector<char> is_within(surface.points.size(), true);
  for(int c = 0; c < surface.number_of_corners(); ++c) {
    missing[surface.vertex[c]] -= surface_angle(surface, c);
    if(!is_within_patch(surface, patch, c))
      is_within[surface.edge_source(c)] = is_within[surface.edge_target(c)] = false;
  }
  double result = 0;
  for(std::size_t v = 0; v < missing.size(); ++v)
    result += is_within[v] ? std::abs(missing[v]) : 0;
  return result;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Crease_division divide_at_creases(const Chart& surface,
                                                                     const std::vector<double>& cost,
                                                                     double angle)
{
  Crease_patches patches = Crease_patch_finder(surface, cost, angle).run();
  Crease_division result;
  result.number_of_patches = static_cast<std::size_t>(
      std::count_if(patches.patches.begin(), patches.patches.end(),
                    [](const Crease_patch& patch) { return !patch.triangles.empty(); }));
  for(const Crease_patch& patch : patches.patches) {
    result.area += patch.area;
    result.flat_area +=
        result.number_of_patches > 1 && patch.is_flat && patch.triangles.size() > 1 ? patch.area : 0;
  }
  result.curvature = curvature_within(patches.patch, surface);
  result.is_seam = Patch_merger(surface, std::move(patches)).run();
  return result;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CREASE_DIVISION_IMPL_H
