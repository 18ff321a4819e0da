// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHOOSE_CORNERS_H
#define FLATTEN_MESH_CHOOSE_CORNERS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/min_quadrilateral_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace flatten_mesh {

namespace internal {

using Corner_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Corner_points = std::vector<Corner_kernel::Point_2>;

// The corners of the smallest rectangle around points
inline Corner_points smallest_rectangle(const Corner_points& points)
{
  CGAL::Polygon_2<Corner_kernel> hull;
  CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
  Corner_points rectangle;
  CGAL::min_rectangle_2(hull.vertices_begin(), hull.vertices_end(), std::back_inserter(rectangle));
  return rectangle;
}

// The vertex of a border that is nearest to a point, of those that are not taken
inline std::size_t nearest_vertex(const Corner_points& border, const Corner_kernel::Point_2& point,
                                  const std::vector<std::size_t>& taken)
{
  std::size_t nearest = border.size();
  for(std::size_t i = 0; i < border.size(); ++i) {
    if(std::find(taken.begin(), taken.end(), i) == taken.end() &&
       (nearest == border.size() ||
        CGAL::compare_distance_to_point(point, border[i], border[nearest]) == CGAL::SMALLER)) {
      nearest = i;
    }
  }
  return nearest;
}

} // namespace internal

// The vertices of a planar border, of at least four, that are nearest to the corners of the smallest rectangle around
// it: where a rectangle changes the map the least, roughly
template <typename Vertex, typename UV_map>
std::array<Vertex, 4> choose_corners(const std::vector<Vertex>& border, const UV_map& uv)
{
  internal::Corner_points points;
  for(const Vertex v : border) {
    points.emplace_back(uv[v].x(), uv[v].y());
  }
  std::vector<std::size_t> ranks;
  for(const auto& corner : internal::smallest_rectangle(points)) {
    ranks.push_back(internal::nearest_vertex(points, corner, ranks));
  }
  std::sort(ranks.begin(), ranks.end());
  return {border[ranks[0]], border[ranks[1]], border[ranks[2]], border[ranks[3]]};
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHOOSE_CORNERS_H
