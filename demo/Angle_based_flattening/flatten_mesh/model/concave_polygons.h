// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CONCAVE_POLYGONS_H
#define FLATTEN_MESH_CONCAVE_POLYGONS_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Model_texture.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

// Whether a polygon is strictly convex, by exact predicates: it turns left at each corner, and goes around only once.
inline bool is_strictly_convex(const std::vector<Kernel::Point_2>& polygon)
{
  std::size_t leftmost = 0; // corners, as seen from their neighbours
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const Kernel::Point_2 &before = polygon[(i + polygon.size() - 1) % polygon.size()],
                          &after = polygon[(i + 1) % polygon.size()];
    if(CGAL::orientation(before, polygon[i], after) != CGAL::LEFT_TURN) {
      return false;
    }
    leftmost += polygon[i] < before && polygon[i] < after;
  }
  return leftmost == 1;
}

// Readers draw a polygon as a fan of triangles from any of its corners. Returns whether all of them are positively oriented, with
// coordinates as they are and rounded to `float`, as in PLY files and most readers.
inline bool has_good_fans(std::vector<Kernel::Point_2> polygon)
{
  if(polygon.size() == 3) {
    return true;
  }
  const bool is_convex = is_strictly_convex(polygon);
  for(Kernel::Point_2& p : polygon) {
    p = Kernel::Point_2(static_cast<float>(p.x()), static_cast<float>(p.y()));
  }
  return is_convex && is_strictly_convex(polygon);
}

// Of each polygon of a model: whether it has coordinates, and a fan that must not be drawn
inline std::vector<bool> concave_polygons(const Model& model, const Model_texture& texture)
{
  std::vector<bool> is_concave(model.number_of_polygons(), false);
  std::vector<Kernel::Point_2> polygon;
  for(Index p = 0; p < model.number_of_polygons(); ++p) {
    polygon.clear();
    for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c) {
      if(model.size(p) > 3 && texture.has_uv(c)) {
        polygon.push_back(texture.uv[c]);
      }
    }
    if(texture.is_turned[p]) {
      std::reverse(polygon.begin(), polygon.end());
    }
    is_concave[p] = !polygon.empty() && !(polygon.size() == model.size(p) && has_good_fans(polygon));
  }
  return is_concave;
}

// The note on polygons that are divided in the output
inline std::string divided_text(const std::vector<bool>& is_divided)
{
  const auto count = static_cast<std::size_t>(std::count(is_divided.begin(), is_divided.end(), true));
  return count_text(count, "polygon") +
         (count == 1 ? " is not convex in the plane, and is" : " are not convex in the plane, and are") +
         " divided into triangles in the output";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CONCAVE_POLYGONS_H
