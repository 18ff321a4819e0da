// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_DIVIDE_KEYHOLES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_DIVIDE_KEYHOLES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/surface_types.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/triangulate.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

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

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_DIVIDE_KEYHOLES_H
