// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_LINK_CORNERS_H
#define FLATTEN_MESH_LINK_CORNERS_H

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;

// Finds the opposite corners of a chart that has its triangles only. What lies on the sides of an edge of more than two
// triangles, or of two that have it in the same direction, stays apart.
inline void link_corners(abf::Chart& chart)
{
  struct Side
  {
    std::pair<int, int> edge; // the smaller vertex first
    int corner;               // which faces it
  };
  std::vector<Side> sides;
  sides.reserve(chart.vertex.size());
  for(int c = 0; c < chart.number_of_corners(); ++c) {
    sides.push_back({std::minmax({chart.edge_source(c), chart.edge_target(c)}), c});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  chart.opposite.assign(chart.vertex.size(), -1);
  for(auto first = sides.begin(), last = first; first != sides.end(); first = last) {
    last = std::find_if(first, sides.end(), [first](const Side& side) { return side.edge != first->edge; });
    const int c = first->corner, d = (last - 1)->corner;
    if(last - first == 2 && chart.edge_source(c) == chart.edge_target(d)) {
      chart.opposite[static_cast<std::size_t>(c)] = d;
      chart.opposite[static_cast<std::size_t>(d)] = c;
    }
  }
}

// Gives each fan of linked triangles around a vertex a vertex of its own. Returns the vertex that each was before.
inline std::vector<int> separate_fans(abf::Chart& chart)
{
  std::vector<int> origins;
  std::vector<int> vertex(chart.vertex.size(), -1);
  abf::Chart result;
  for(int start = 0; start < chart.number_of_corners(); ++start) {
    if(vertex[static_cast<std::size_t>(start)] < 0) {
      for(const int c : abf::corners_around(chart, start)) {
        vertex[static_cast<std::size_t>(c)] = static_cast<int>(origins.size());
      }
      origins.push_back(chart.vertex[static_cast<std::size_t>(start)]);
      result.points.push_back(chart.points[static_cast<std::size_t>(origins.back())]);
    }
  }
  chart.vertex = std::move(vertex);
  chart.points = std::move(result.points);
  return origins;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_LINK_CORNERS_H
