// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact tests whether a polygon in the plane is strictly convex, also after rounding to `float`.
// `make_polygons_convex.h` mends what fails them: readers triangulate polygons as fans, which may turn over at a
// concave corner.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_POLYGONS_CONVEX_POLYGON_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_POLYGONS_CONVEX_POLYGON_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>

#include <CGAL/Kernel/global_functions.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Readers draw a polygon as a fan of triangles from any corner, and many of them round coordinates to `float` before.
// All these triangles are positively oriented if and only if the polygon is strictly convex, before and after.
inline Exact_point_2 rounded_to_float(const Exact_point_2& p)
{
  return Exact_point_2(static_cast<float>(p.x()), static_cast<float>(p.y()));
}

inline bool turns_left(const Exact_point_2& p, const Exact_point_2& q, const Exact_point_2& r)
{
  return CGAL::orientation(p, q, r) == CGAL::LEFT_TURN &&
         CGAL::orientation(rounded_to_float(p), rounded_to_float(q), rounded_to_float(r)) == CGAL::LEFT_TURN;
}

// The number of corners at which the polygon does not turn left
inline std::size_t count_bad_corners(const std::vector<Exact_point_2>& polygon)
{
  const std::size_t size = polygon.size();
  std::size_t count = 0;
  for(std::size_t i = 0; i < size; ++i)
    count += !turns_left(polygon[i], polygon[(i + 1) % size], polygon[(i + 2) % size]);
  return count;
}

// Whether all fans are good. A polygon that turns left everywhere is convex if it goes around once: if only one corner
// is to the left of both its neighbors.
inline bool is_strictly_convex(const std::vector<Exact_point_2>& polygon)
{
  const std::size_t size = polygon.size();
  std::size_t leftmost = 0;
  for(std::size_t i = 0; i < size; ++i)
    leftmost += polygon[(i + 1) % size] < polygon[i] && polygon[(i + 1) % size] < polygon[(i + 2) % size];
  return leftmost == 1 && count_bad_corners(polygon) == 0;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_POLYGONS_CONVEX_POLYGON_H
