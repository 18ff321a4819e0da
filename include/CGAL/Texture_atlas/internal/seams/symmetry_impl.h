// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The bodies of the functions of `symmetry.h`, which includes it; the compiled library has it in
// `angle_based_flattening_symmetry.cpp`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/seams/edge_graph.h>
#include <CGAL/Texture_atlas/internal/seams/mirror_plane.h>
#include <CGAL/Texture_atlas/internal/seams/mirror_seams.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_objects.h>
#include <CGAL/Texture_atlas/internal/seams/sides_of_plane.h>
#include <CGAL/Texture_atlas/internal/seams/symmetry.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal {

CGAL_ANGLE_BASED_FLATTENING_INLINE Mirror_plane fit_mirror_plane(const Triangle_arrays& mesh)
{
  return Mirror_plane_finder(mesh).run();
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<char>
mirror_seams(const Triangle_arrays& mesh, const Edge_graph& graph, const Mirror_plane& plane,
             const std::vector<char>& may_be_seam, const std::vector<char>& is_seam, int kept)
{
  return Seam_mirror(mesh, graph, plane, may_be_seam).run(is_seam, kept);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE double
asymmetry_of_seams(const Edge_graph& graph, const std::vector<char>& is_seam, const Mirror_plane& plane)
{
  std::vector<Seam_kernel::Segment_3> segments;
  for(std::size_t e = 0; e < is_seam.size(); ++e)
    if(is_seam[e] && graph.length(e) > 0)
      segments.emplace_back(graph.points[graph.ends[e][0]], graph.points[graph.ends[e][1]]);
  if(segments.empty())
    return 0;
  double sum = 0, length = 0;
  const Nearest_objects<Seam_kernel::Segment_3> seams(segments);
  for(const Seam_kernel::Segment_3& segment : segments) {
    const double l = std::sqrt(segment.squared_length());
    const Seam_kernel::Point_3 middle = CGAL::midpoint(segment.source(), segment.target());
    sum += l * std::sqrt(seams.squared_distance(plane.mirrored(middle)));
    length += l;
  }
  return sum / length;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_IMPL_H
