// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CONCAVE_POLYGONS_H
#define FLATTEN_MESH_CONCAVE_POLYGONS_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/float_grid.h>
#include <CGAL/Texture_atlas/internal/polygons/make_polygons_convex.h>
#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

using CGAL::Surface_mesh_parameterization::internal::ABF::Float_grid;

// Whether all triangles of all fans are positively oriented, also with coordinates in `float`
inline bool has_good_fans(const std::vector<Kernel::Point_2>& polygon, const Float_grid& grid)
{
  namespace ABF = CGAL::Surface_mesh_parameterization::internal::ABF;
  std::vector<ABF::Exact_point_2> points;
  for(const Kernel::Point_2& p : polygon)
    points.emplace_back(p.x(), p.y());
  return points.size() == 3 || CGAL::Texture_atlas::internal::is_strictly_convex(points, grid);
}

// Of each polygon of a model: whether it has coordinates, and a fan that must not be drawn
inline std::vector<bool> concave_polygons(const Model& model, const Model_texture& texture,
                                          const Float_grid& grid)
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
    is_concave[p] = !polygon.empty() && !(polygon.size() == model.size(p) && has_good_fans(polygon, grid));
  }
  return is_concave;
}

// The note on polygons that vertices were moved for, and those that are divided in the output. Empty if there are none.
inline std::string polygons_text(const std::size_t mended, const std::vector<bool>& is_divided)
{
  const auto divided = static_cast<std::size_t>(std::count(is_divided.begin(), is_divided.end(), true));
  const std::string reason = ": other programs would draw triangles that overlap";
  const std::string mending = count_text(mended, "polygon") +
                              " made convex in the plane by small moves of vertices",
                    dividing = std::to_string(divided) + " divided into triangles in the output";
  if(mended > 0) {
    return mending + (divided > 0 ? ", and " + dividing : "") + reason;
  }
  return divided > 0 ? count_text(divided, "polygon") + dividing.substr(dividing.find(' ')) + reason : "";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CONCAVE_POLYGONS_H
