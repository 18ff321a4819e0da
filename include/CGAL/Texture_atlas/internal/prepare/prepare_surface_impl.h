// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_SURFACE_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_SURFACE_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/build_mesh_impl.h>
#include <CGAL/Texture_atlas/internal/prepare/check_polygons.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface.h>
#include <CGAL/Texture_atlas/internal/prepare/separate_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/set_aside.h>
#include <CGAL/Texture_atlas/internal/prepare/triangulate.h>
#include <CGAL/Texture_atlas/internal/prepare/weld_soup.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
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

// Whether a polygon runs along a side in both directions: formats without holes join a hole to the border by such a
// bridge.
inline bool has_bridge(const Polygon& polygon)
{
  if(polygon.size() < 6 || !has_repeated_vertex(polygon)) {
    return false;
  }
  std::set<std::pair<std::size_t, std::size_t>> sides;
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    sides.emplace(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]);
  }
  return std::any_of(sides.begin(), sides.end(), [&sides](const std::pair<std::size_t, std::size_t>& side) {
    return sides.count({side.second, side.first}) > 0;
  });
}

// Replaces polygons with a hole that is joined to their border by their triangles.
inline void divide_keyholes(const Surface_soup& model, Polygon_soup& soup, Notes& notes)
{
  std::size_t divided = 0, first = 0;
  const std::size_t polygons = soup.polygons.size();
  for(std::size_t p = 0; p < polygons; ++p) {
    if(!has_bridge(soup.polygons[p])) {
      continue;
    }
    const Polygon polygon = soup.polygons[p];
    std::vector<Kernel::Point_3> points;
    std::set<std::pair<std::size_t, std::size_t>> sides;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      points.push_back(soup.points[polygon[i]]);
      sides.insert(std::minmax(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]));
    }
    if(!std::all_of(points.begin(), points.end(), is_finite)) {
      continue;
    }
    const Polygon_triangles triangles = triangulate_polygon(points, [&](const Index i, const Index j) {
      return polygon[i] == polygon[j] || sides.count(std::minmax(polygon[i], polygon[j])) > 0;
    });
    const auto is_degenerate = [&](const Index t) {
      const std::size_t a = polygon[triangles.corners[3 * t]], b = polygon[triangles.corners[3 * t + 1]],
                        c = polygon[triangles.corners[3 * t + 2]];
      return a == b || b == c || c == a;
    };
    bool has_degenerate = false;
    for(Index t = 0; t < triangles.size(); ++t) {
      has_degenerate = has_degenerate || is_degenerate(t);
    }
    if(has_degenerate) {
      continue;
    }
    std::vector<Index> corners;
    for(std::size_t i = 0; i < polygon.size(); ++i) {
      corners.push_back(corner_in_model(model, soup, p, i));
    }
    for(Index t = 0; t < triangles.size(); ++t) {
      const std::size_t place = t == 0 ? p : soup.polygons.size();
      if(t > 0) {
        soup.polygons.emplace_back();
        soup.origins.push_back(soup.origins[p]);
        soup.is_turned.push_back(soup.is_turned[p]);
      }
      soup.polygons[place].clear();
      soup.corners[place].clear();
      for(Index k = 3 * t; k < 3 * t + 3; ++k) {
        soup.polygons[place].push_back(polygon[triangles.corners[k]]);
        soup.corners[place].push_back(corners[triangles.corners[k]]);
      }
    }
    if(triangles.size() > 0) {
      first = divided == 0 ? p : first;
      ++divided;
    }
  }
  if(divided > 0) {
    notes.add(count_text(divided, "face has a hole", "faces have holes") +
              " that a bridge joins to the border, and became triangles; the first is " +
              face_name(soup.origins[first]));
  }
}

inline Mesh build_separated_polygon_mesh(const Surface_soup& model, Polygon_soup& soup, const bool repair,
                                         Notes& notes)
{
  try {
    return build_polygon_mesh(soup);
  } catch(const Input_error&) {
    if(!repair) {
      throw;
    }
    separate_soup(model, soup, notes);
    return build_polygon_mesh(soup);
  }
}

// Removes polygons that are not to be flattened. Returns how many.
inline std::size_t remove_left_out(const std::vector<bool>& is_left_out, Polygon_soup& soup)
{
  const auto number = static_cast<std::size_t>(std::count(is_left_out.begin(), is_left_out.end(), true));
  if(number > 0) {
    std::vector<Index> part_of;
    for(const bool is_one : is_left_out) {
      part_of.push_back(is_one ? 0 : no_index);
    }
    leave_out(soup, part_of, {Skipped_part()});
    soup.left_out.clear(); // nothing is wrong with it
  }
  return number;
}

// Removes polygons without area, so that they neither tear charts nor make edges of three faces. Returns which
// polygons of the model these are; nothing if there are none.
inline std::vector<bool> remove_polygons_without_area(const Surface_soup& model,
                                                      const std::vector<bool>& is_far, Polygon_soup& soup)
{
  const std::vector<bool> is_one = have_no_area(soup, is_far);
  if(std::find(is_one.begin(), is_one.end(), true) == is_one.end()) {
    return {};
  }
  std::vector<bool> has_no_area(model.number_of_polygons(), false);
  std::vector<Index> part_of;
  for(std::size_t p = 0; p < is_one.size(); ++p) {
    has_no_area[soup.origins[p]] = is_one[p];
    part_of.push_back(is_one[p] ? 0 : no_index);
  }
  leave_out(soup, part_of, {Skipped_part()});
  soup.left_out.clear(); // they get coordinates later
  return has_no_area;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Prepared_surface prepare_surface(const Surface_soup& given,
                                                                    const Preparation& how, Notes& notes)
{
  Prepared_surface surface;
  Polygon_soup soup = polygon_soup(given);
  tell_repetitions(soup, notes);
  check_not_empty(soup);
  valences(soup); // throws if a vertex does not exist
  surface.left_out = remove_left_out(how.is_left_out, soup);
  const std::vector<bool> is_far = far_points(soup);
  std::vector<bool> has_no_area = remove_polygons_without_area(given, is_far, soup);
  divide_keyholes(given, soup, notes);
  set_aside(soup, is_far, how.repair);
  if(how.repair) {
    leave_out_duplicates(soup);
    weld_soup(how.welding, soup, notes);
    separate_backs(soup, notes);
  }
  while(!soup.polygons.empty() && surface.mesh.is_empty()) {
    std::vector<std::size_t> undivided;
    Surface_of_model built =
        end_surface(given, soup, build_separated_polygon_mesh(given, soup, how.repair, notes), undivided);
    if(undivided.empty()) {
      surface.mesh = std::move(built.mesh);
      surface.origins = std::move(built.origins);
    } else {
      set_undivided_aside(undivided, soup);
    }
  }
  surface.origins.is_turned.resize(given.number_of_polygons(), false); // also if no face remains
  surface.origins.has_no_area = std::move(has_no_area);
  surface.set_aside = std::move(soup.left_out);
  return surface;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_SURFACE_IMPL_H
