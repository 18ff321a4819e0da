// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_POLYGONS_WITHOUT_AREA_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_POLYGONS_WITHOUT_AREA_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// How far points are from a line, at most, in units of their largest distance; 0 if that is not more than the rounding
// of their coordinates. Infinity if there is no point, or one that is not finite.
inline double distance_from_line(const std::vector<Kernel::Point_3>& points)
{
  const double infinity = std::numeric_limits<double>::infinity();
  double largest = 0;
  for(const Kernel::Point_3& p : points) {
    for(int i = 0; i < 3; ++i) {
      largest = std::isfinite(p[i]) ? (std::max)(largest, std::abs(p[i])) : infinity;
    }
  }
  if(points.empty() || largest == infinity) {
    return infinity;
  }
  const auto nearer = [&points](const Kernel::Point_3& p, const Kernel::Point_3& q) {
    return CGAL::squared_distance(points[0], p) < CGAL::squared_distance(points[0], q);
  };
  // Numbers are divided by the largest one, so that none overflows or vanishes.
  const double scale = largest > 0 ? largest : 1;
  const Kernel::Vector_3 side = (*std::max_element(points.begin(), points.end(), nearer) - points[0]) / scale;
  const double length = std::sqrt(side.squared_length());
  double distance = 0;
  for(const Kernel::Point_3& p : points) {
    const double area = std::sqrt(CGAL::cross_product(side, (p - points[0]) / scale).squared_length());
    distance = length > 0 ? (std::max)(distance, area / length) : 0;
  }
  return distance <= 4 * std::numeric_limits<double>::epsilon() ? 0 : distance / length;
}

using Point_pair = std::pair<Kernel::Point_3, Kernel::Point_3>;

// A side of a polygon by its points: vertices at the same place may be welded later.
inline Point_pair points_of_side(const Polygon_soup& soup, const Polygon& polygon, const std::size_t i)
{
  return (std::minmax)(soup.points[polygon[i]], soup.points[polygon[i + 1 < polygon.size() ? i + 1 : 0]]);
}

// The polygons whose points are on one line, so that they have no area, and can only be mapped to a part of a line.
// Those at another polygon may be so up to the rounding of `float`, in which many programs write the middle of an edge.
// Points that are too far away say nothing of a polygon.
inline std::vector<bool> have_no_area(const Polygon_soup& soup, const std::vector<bool>& is_far)
{
  const double rounding = 5e-8;
  std::vector<bool> result;
  std::map<Point_pair, bool> sides; // of those that are nearly so: whether another polygon has it
  std::vector<std::size_t> nearly;
  std::vector<Kernel::Point_3> points;
  for(std::size_t p = 0; p < soup.polygons.size(); ++p) {
    const Polygon& polygon = soup.polygons[p];
    points.clear();
    for(const std::size_t v : polygon) {
      points.push_back(soup.points[v]);
    }
    double distance = distance_from_line(points);
    if(distance <= rounding &&
       (polygon.size() < 3 || has_repeated_vertex(polygon) ||
        std::any_of(polygon.begin(), polygon.end(), [&is_far](const std::size_t v) { return is_far[v]; }))) {
      distance = 1; // these are set aside for another reason
    }
    result.push_back(distance <= rounding);
    if(distance > 0 && distance <= rounding) {
      nearly.push_back(p);
      for(std::size_t i = 0; i < polygon.size(); ++i) {
        sides.emplace(points_of_side(soup, polygon, i), false);
      }
    }
  }
  for(std::size_t p = 0; p < soup.polygons.size() && !nearly.empty(); ++p) {
    for(std::size_t i = 0; i < soup.polygons[p].size() && !result[p]; ++i) {
      if(const auto side = sides.find(points_of_side(soup, soup.polygons[p], i)); side != sides.end()) {
        side->second = true;
      }
    }
  }
  for(const std::size_t p : nearly) {
    const Polygon& polygon = soup.polygons[p];
    result[p] = false;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      result[p] = result[p] || sides.at(points_of_side(soup, polygon, i));
    }
  }
  return result;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_POLYGONS_WITHOUT_AREA_H
