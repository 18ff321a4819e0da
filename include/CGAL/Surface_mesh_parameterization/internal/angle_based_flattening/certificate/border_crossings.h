// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the pairs of border edges that touch, and tells by exact predicates whether the border of a map is simple.
// `certify_chart.h`, `planar_map.h` and `measure_chart.h` ask it; so do `separate_overlaps.h` and injective maps.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_CROSSINGS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_CROSSINGS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

typedef CGAL::Box_intersection_d::Box_with_info_d<double, 2, int> Indexed_box;

// The bounding boxes of those edges whose points are finite.
template <typename Point>
std::vector<Indexed_box> edge_boxes(const std::vector<Border_edge>& edges, const std::vector<Point>& uv)
{
  std::vector<Indexed_box> boxes;
  for(std::size_t i = 0; i < edges.size(); ++i) {
    const Point &p = uv[edges[i].source], &q = uv[edges[i].target];
    if(is_finite_point(p) && is_finite_point(q))
      boxes.emplace_back(p.bbox() + q.bbox(), static_cast<int>(i));
  }
  return boxes;
}

// The pairs of border edges that touch, as sorted pairs of their indices in `edges`. It takes `O(b log b)` time to see
// that there is none; else the pairs of edges whose bounding boxes intersect are looked at.
template <typename Point>
std::vector<std::pair<int, int>> touching_edges(const std::vector<Border_edge>& edges,
                                                const std::vector<Point>& uv)
{
  std::vector<std::pair<int, int>> pairs;
  if(!Border_sweep<Point>(edges, uv).finds_touching_edges())
    return pairs;
  std::vector<Indexed_box> boxes = edge_boxes(edges, uv);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Indexed_box& a, const Indexed_box& b) {
    if(touch(edges[a.info()], edges[b.info()], uv))
      pairs.push_back(std::minmax({a.info(), b.info()}));
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

// The pairs of border edges that touch, as the corners that face them.
inline std::vector<std::pair<int, int>> border_crossings(const Corner_table& chart,
                                                         const std::vector<Corner_table::Point_2>& uv)
{
  std::vector<int> corners;
  for(const std::vector<int>& border : chart.borders)
    corners.insert(corners.end(), border.begin(), border.end());
  std::vector<std::pair<int, int>> pairs = touching_edges(border_edges(chart), exact_points(uv));
  for(std::pair<int, int>& pair : pairs)
    pair = {corners[pair.first], corners[pair.second]};
  return pairs;
}

// Whether the borders are simple polygons that do not touch one another, the holes are within the outer one and beside
// one another, and turn the other way. With no flipped triangle, the map is then injective: see
// `Planar_map::is_injective()`.
inline bool is_border_simple(const Corner_table& chart, const std::vector<Exact_point_2>& uv)
{
  return bounds_region(border_edges(chart), uv);
}

inline bool is_border_simple(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv)
{
  return is_border_simple(chart, exact_points(uv));
}

#ifdef CGAL_ANGLE_BASED_FLATTENING_COMPILED
extern template std::vector<std::pair<int, int>> touching_edges(const std::vector<Border_edge>&,
                                                                const std::vector<Exact_point_2>&);
#endif

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_CROSSINGS_H
