// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ROUND_CHARTS_H
#define FLATTEN_MESH_ROUND_CHARTS_H

#include "flatten_mesh/atlas/place_charts.h"
#include "pictures/textured_atlas.h"
#include "flatten_mesh/output_floats.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Texture_atlas/internal/polygons/round_to_floats.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace pictures;
using namespace CGAL::Texture_atlas::internal::prepare;

// Rounds the coordinates of charts, which do not fill the unit square. Throws if a chart is not injective then.
inline void round_charts(const Mesh& mesh, const Atlas& atlas, const std::size_t charts,
                         const Float_grid& grid)
{
  namespace ABF = CGAL::Surface_mesh_parameterization::internal::ABF;
  std::map<std::pair<Vertex, Kernel::Point_2>, int> numbers; // of the vertices of charts
  std::vector<int> corners;
  std::vector<ABF::Chart::Point_2> uv;
  const auto number = [&](const Halfedge h) {
    return numbers.try_emplace({mesh.target(h), atlas.uv[h]}, static_cast<int>(numbers.size())).first->second;
  };
  std::vector<std::vector<ABF::Border_edge>> borders(charts);
  for_each_corner(mesh, atlas, [&](const Halfedge h, const std::size_t c) {
    corners.push_back(number(h));
    if(is_chart_border(mesh, atlas, h)) {
      borders[c].push_back({number(mesh.prev(h)), number(h)});
    }
  });
  uv.resize(numbers.size());
  for(const auto& [vertex, i] : numbers) {
    uv[static_cast<std::size_t>(i)] = {vertex.second.x(), vertex.second.y()};
  }
  TA::internal::Float_rounder rounder(corners, grid, uv);
  for(const std::vector<ABF::Border_edge>& border : borders) {
    rounder.keep_gaps(border);
  }
  const bool is_oriented = rounder.run().empty();
  const std::vector<ABF::Exact_point_2> points = ABF::exact_points(uv);
  if(!is_oriented || !std::all_of(borders.begin(), borders.end(), [&points](const auto& border) {
       return ABF::bounds_region(border, points);
     })) {
    throw Precision_exceeded(
        "a triangle is so thin that it is turned over, or a chart overlaps itself, in world "
        "units as the output holds them: float; use --units square without --no-pack, or an "
        "OBJ file");
  }
  auto corner = corners.begin();
  for_each_corner(mesh, atlas, [&](const Halfedge h, std::size_t) {
    const ABF::Chart::Point_2& p = uv[static_cast<std::size_t>(*corner++)];
    atlas.uv[h] = Kernel::Point_2(p.x(), p.y());
  });
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_ROUND_CHARTS_H
