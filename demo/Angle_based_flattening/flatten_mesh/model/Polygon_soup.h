// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_POLYGON_SOUP_H
#define FLATTEN_MESH_POLYGON_SOUP_H

#include "flatten_mesh/model/Model.h"

#include <cstddef>
#include <vector>

namespace flatten_mesh {

using Polygon = std::vector<std::size_t>;

// The points and polygons of a model, which can be repaired.
struct Polygon_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<Polygon> polygons;
  std::vector<Index> origins;  // of each polygon, in the model
  std::vector<bool> is_turned; // of each polygon: its corners are in reverse order
  bool is_welded = false;
};

// All polygons of a model, whatever they are.
inline Polygon_soup polygon_soup(const Model& model)
{
  Polygon_soup soup;
  soup.points = model.points;
  soup.is_welded = model.is_welded;
  const std::size_t polygons = model.number_of_polygons();
  soup.polygons.reserve(polygons);
  for(std::size_t p = 0; p < polygons; ++p) {
    soup.polygons.emplace_back(model.vertices.begin() + model.first_corners[p],
                               model.vertices.begin() + model.first_corners[p + 1]);
    soup.origins.push_back(static_cast<Index>(p));
  }
  soup.is_turned.assign(polygons, false);
  return soup;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_POLYGON_SOUP_H
