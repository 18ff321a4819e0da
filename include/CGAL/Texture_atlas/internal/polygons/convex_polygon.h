// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tests whether a polygon in the plane is strictly convex, also after rounding to `float`.
// `make_polygons_convex.h` mends what fails them: readers triangulate polygons as fans, which may turn over at a
// concave corner.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_POLYGONS_CONVEX_POLYGON_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_POLYGONS_CONVEX_POLYGON_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/float_grid.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Readers draw a polygon as a fan of triangles from any corner, and many of them round coordinates to `float` before.
// All these triangles are positively oriented if the polygon is strictly convex, before and after.
//
// Rounding moves a corner, and the line through its neighbors, by less than 3/4 of the grid's step each. A corner that
// is two steps off the line turns left before and after, and one that is straight counts as straight wherever it is.
inline bool turns_left(const Exact_point_2& p, const Exact_point_2& q, const Exact_point_2& r,
                       const Float_grid& grid)
{
  double step = 0;
  for(double x : {p.x(), p.y(), q.x(), q.y(), r.x(), r.y()})
    step = (std::max)(step, grid.step(x));
  return 2 * CGAL::area(p, q, r) > 2 * step * std::sqrt(CGAL::squared_distance(p, r)) &&
         CGAL::orientation(p, q, r) == CGAL::LEFT_TURN;
}

// The number of corners at which the polygon does not turn left
inline std::size_t count_bad_corners(const std::vector<Exact_point_2>& polygon, const Float_grid& grid)
{
  const std::size_t size = polygon.size();
  std::size_t count = 0;
  for(std::size_t i = 0; i < size; ++i)
    count += !turns_left(polygon[i], polygon[(i + 1) % size], polygon[(i + 2) % size], grid);
  return count;
}

// Whether all fans are good. A polygon that turns left everywhere is convex if it goes around once: if only one corner
// is to the left of both its neighbors.
inline bool is_strictly_convex(const std::vector<Exact_point_2>& polygon, const Float_grid& grid)
{
  const std::size_t size = polygon.size();
  std::size_t leftmost = 0;
  for(std::size_t i = 0; i < size; ++i)
    leftmost += polygon[(i + 1) % size] < polygon[i] && polygon[(i + 1) % size] < polygon[(i + 2) % size];
  return leftmost == 1 && count_bad_corners(polygon, grid) == 0;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_POLYGONS_CONVEX_POLYGON_H
