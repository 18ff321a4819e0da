// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Symmetric seams on flat arrays, without a mesh: a plane of symmetry, on which side of it vertices are, and what
// `symmetry_impl.h` computes with them. `symmetrize_seams.h` calls it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/triangle_arrays.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Origin.h>

#include <cmath>
#include <vector>

namespace CGAL::Texture_atlas::internal {

struct Mirror_plane
{
  Seam_kernel::Vector_3 normal{1, 0, 0}; // of length 1
  double offset = 0;                     // of the points of the plane along the normal
  double deviation = 0;                  // the root mean square distance of the mirror image from the surface

  double height(const Seam_kernel::Point_3& p) const { return normal * (p - CGAL::ORIGIN) - offset; }
  Seam_kernel::Point_3 mirrored(const Seam_kernel::Point_3& p) const { return p - 2 * height(p) * normal; }
};

inline double diagonal_of(const std::vector<Seam_kernel::Point_3>& points)
{
  CGAL::Bbox_3 box;
  for(const Seam_kernel::Point_3& p : points)
    box += p.bbox();
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
}

// On which side of the plane each vertex is: -1, 1, or 0. Of two vertices on different sides of the plane that an edge
// joins, the nearer one counts as on the plane.
inline std::vector<signed char> sides_of_vertices(const Edge_graph& graph, const Mirror_plane& plane)
{
  std::vector<double> height;
  for(const Seam_kernel::Point_3& p : graph.points)
    height.push_back(plane.height(p));
  std::vector<signed char> side;
  for(double h : height)
    side.push_back(static_cast<signed char>((h > 0) - (h < 0)));
  for(const auto& [a, b] : graph.ends)
    if(height[a] * height[b] < 0)
      side[std::abs(height[b]) < std::abs(height[a]) ? b : a] = 0;
  return side;
}

// The plane in which the surface is most nearly symmetric. At least one triangle has an area.
CGAL_ANGLE_BASED_FLATTENING_INLINE Mirror_plane fit_mirror_plane(const Triangle_arrays& mesh);

// For each edge whether it is a seam, with the seams on side `kept` of the plane, -1 or 1, on both sides
CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<char>
mirror_seams(const Triangle_arrays& mesh, const Edge_graph& graph, const Mirror_plane& plane,
             const std::vector<char>& may_be_seam, const std::vector<char>& is_seam, int kept);

// The mean distance of the mirror images of seams from the seams
CGAL_ANGLE_BASED_FLATTENING_INLINE double
asymmetry_of_seams(const Edge_graph& graph, const std::vector<char>& is_seam, const Mirror_plane& plane);

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SYMMETRY_H
