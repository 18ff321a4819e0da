// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles for a ring of vertices: the patch that bends least, or a fan where there is none.
// `fill_holes.h` asks for one patch for each hole.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_HOLES_PATCH_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_HOLES_PATCH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <array>
#include <iterator>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The triangles that close a hole, counterclockwise as the ring of its `n` vertices is: numbers along the ring, and `n`
// for a new vertex in the middle.
typedef std::vector<std::array<int, 3>> Patch;

// Larger rings get a fan: the search among Delaunay triangles takes up to 0.3 s for a ring of this size, and 4 s for
// one of twice the size.
inline constexpr int largest_patch = 1000;

// Where that finds nothing, the search among all triangles takes 0.04 s for a ring of this size, and cubic time.
inline constexpr int largest_patch_of_any_triangles = 100;

inline Patch fan(int n)
{
  Patch patch;
  for(int i = 0; i < n; ++i)
    patch.push_back({i, (i + 1) % n, n});
  return patch;
}

// The patch of the least bend, also against the triangles around the hole, whose third vertices are at `outer`. Empty
// if there is none without degenerate triangles, or if the ring is too large. Convex hulls need exact predicates. A
// ring whose last point is the first one again has a degenerate edge, while CGAL takes it for closed.
inline Patch
least_bent_patch(const std::vector<Exact_predicates_inexact_constructions_kernel::Point_3>& ring,
                 const std::vector<Exact_predicates_inexact_constructions_kernel::Point_3>& outer)
{
  const int n = static_cast<int>(ring.size());
  if(n > largest_patch || ring.front() == ring.back())
    return {};
  std::vector<CGAL::Triple<int, int, int>> triples;
  Polygon_mesh_processing::triangulate_hole_polyline(
      ring, outer, std::back_inserter(triples),
      CGAL::parameters::do_not_use_cubic_algorithm(n > largest_patch_of_any_triangles));
  Patch patch;
  for(const auto& t : triples)
    patch.push_back({t.first, t.second, t.third});
  return static_cast<int>(patch.size()) == n - 2 ? patch : Patch();
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_HOLES_PATCH_H
