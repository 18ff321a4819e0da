// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which vertices of the border of a map are the corners of a rectangle that changes the map little.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_CORNERS_OF_MAP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_CORNERS_OF_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The vertices of a planar border, of at least four, that are nearest to the corners of the smallest rectangle around
// it: where a rectangle changes the map the least, roughly. They are in the order of the border.
template <typename Vertex, typename VertexUVMap>
std::array<Vertex, 4> corners_of_map(const std::vector<Vertex>& border, const VertexUVMap& uv)
{
  typedef Exact_predicates_inexact_constructions_kernel Kernel;
  std::vector<Kernel::Point_2> points, rectangle;
  for(const Vertex& v : border)
    points.emplace_back(uv[v].x(), uv[v].y());
  Polygon_2<Kernel> hull;
  convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  min_rectangle_2(hull.vertices_begin(), hull.vertices_end(), std::back_inserter(rectangle));
  std::vector<std::size_t> ranks(border.size());
  std::iota(ranks.begin(), ranks.end(), std::size_t(0));
  for(std::size_t i = 0; i < 4; ++i) {
    const auto first = ranks.begin() + static_cast<std::ptrdiff_t>(i);
    const auto nearest = std::min_element(first, ranks.end(), [&](std::size_t a, std::size_t b) {
      const Comparison_result order = compare_distance_to_point(rectangle[i], points[a], points[b]);
      return order == SMALLER || (order == EQUAL && a < b);
    });
    std::iter_swap(first, nearest);
  }
  std::sort(ranks.begin(), ranks.begin() + 4);
  return {border[ranks[0]], border[ranks[1]], border[ranks[2]], border[ranks[3]]};
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_CORNERS_OF_MAP_H
