// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_JOIN_VERTICES_H
#define FLATTEN_MESH_JOIN_VERTICES_H

#include "flatten_mesh/model/Model.h"

#include <CGAL/Texture_atlas/internal/prepare/places_of_points.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>
#include <CGAL/Texture_atlas/internal/prepare/weld_soup.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// Joins points of a model at the same place, from the first point and polygon on, as faces that meet are joined
// elsewhere. What corners have of their own stays. Points that no corner uses any longer are removed.
inline void join_vertices(const std::size_t first_polygon, const std::size_t first_point, Model& model)
{
  Polygon_soup soup;
  soup.points.assign(model.points.begin() + static_cast<std::ptrdiff_t>(first_point), model.points.end());
  soup.polygons.reserve(model.number_of_polygons() - first_polygon);
  for(std::size_t p = first_polygon; p < model.number_of_polygons(); ++p) {
    Polygon polygon;
    for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c) {
      polygon.push_back(model.vertices[c] - first_point);
    }
    soup.polygons.push_back(std::move(polygon));
  }
  std::vector<Index> places = places_of_points(soup, 0);
  if(are_all_different(places)) {
    return;
  }
  join_sides(std::move(places), 0, soup);

  const std::vector<Point_color> colors = model.colors;
  std::vector<Index> numbers(soup.points.size(), no_index);
  model.points.resize(first_point, Kernel::Point_3(CGAL::ORIGIN));
  model.colors.resize((std::min)(first_point, colors.size()));
  Index corner = model.first_corners[first_polygon];
  for(const Polygon& polygon : soup.polygons) {
    for(const std::size_t v : polygon) {
      const Index before = model.vertices[corner];
      if(numbers[v] == no_index) {
        numbers[v] = static_cast<Index>(model.points.size());
        model.points.push_back(soup.points[v]);
        if(before < colors.size()) {
          model.colors.push_back(colors[before]);
        }
      }
      model.vertices[corner++] = numbers[v];
    }
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_JOIN_VERTICES_H
