// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Certifies the charts of a part with their final, rounded coordinates. Packing moves and scales charts, so earlier
// tests do not count. `build_atlas_impl.h` makes parts anew that fail.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CERTIFY_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CERTIFY_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/build_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_surface.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The border edges of each chart of a part
inline std::vector<std::vector<Border_edge>> borders_of_pieces(const Part_atlas& part)
{
  std::vector<std::vector<Border_edge>> borders(part.pieces.size());
  for(const std::vector<int>& border : part.chart.borders)
    for(int c : border)
      borders[part.piece[c / 3]].push_back({part.chart.edge_source(c), part.chart.edge_target(c)});
  return borders;
}

// What keeps the map of a part from being injective, if anything
struct Map_defect
{
  Diagnosis status = Diagnosis::NOTHING_WRONG;
  int vertex = -1;                   // of the chart
  std::size_t number_of_flipped = 0; // triangles
};

// By exact predicates
inline Map_defect find_map_defect(const Part_atlas& part)
{
  const std::vector<Exact_point_2> uv = exact_points(part.uv);
  const std::vector<int> flipped = flipped_triangles(part.chart.vertex, uv);
  if(!flipped.empty())
    return {Diagnosis::FLIPPED_TRIANGLES, part.chart.vertex[3 * flipped.front()], flipped.size()};
  for(const std::vector<Border_edge>& border : borders_of_pieces(part))
    if(!bounds_region(border, uv))
      return {Diagnosis::OVERLAPPING, border.front().source, 0};
  return {};
}

// Returns why the final map of a part is not injective, or nothing.
inline std::string certify_part(const Part_atlas& part)
{
  const Map_defect defect = find_map_defect(part);
  if(defect.status == Diagnosis::NOTHING_WRONG)
    return "";
  return "the final coordinates have too few digits for " +
         (defect.number_of_flipped > 0 ? std::to_string(defect.number_of_flipped) + " triangle(s), one"
                                       : std::string("the border")) +
         " at the vertex at " + position_text(part.chart, defect.vertex);
}

// Of a map that was given
inline std::string defect_text(const Part_atlas& part, const Map_defect& defect)
{
  const std::string chart = "the given chart of " + std::to_string(part.piece.size()) + " triangle(s)",
                    vertex = " the vertex at " + position_text(part.chart, defect.vertex);
  if(defect.status == Diagnosis::FLIPPED_TRIANGLES)
    return chart + " has " + std::to_string(defect.number_of_flipped) +
           " that are flipped or have no area, one at" + vertex;
  return chart +
         (defect.status == Diagnosis::OVERLAPPING ? " overlaps itself; its border runs through"
                                                  : " has no coordinates at") +
         vertex;
}

// A part with the map that it has, as one chart, on a page whose sides have this ratio. Fails if the map is not
// injective.
inline Part_atlas given_part(const Surface_part& part, double page_aspect)
{
  Part_atlas atlas;
  Piece whole = opened_along_seams(part.chart, part.cost, {});
  atlas.uv = whole.map_from(part.given_map);
  atlas.chart = std::move(whole.chart);
  atlas.piece.assign(whole.triangles.size(), 0);
  atlas.pieces.resize(1);
  atlas.pieces.front().method = Atlas_report::GIVEN;
  atlas.pieces.front().seam_lengths = Atlas_report::OTHER_METHOD;
  const auto bad = std::find_if(atlas.uv.begin(), atlas.uv.end(), [](const Chart::Point_2& p) {
    return !(std::isfinite(p.x()) && std::isfinite(p.y()));
  });
  Map_defect defect;
  if(bad != atlas.uv.end())
    defect = {Diagnosis::NO_TEXTURE_COORDINATES, static_cast<int>(bad - atlas.uv.begin()), 0};
  else
    defect = find_map_defect(atlas);
  atlas.status = defect.status;
  if(!atlas.succeeded())
    atlas.message = defect_text(atlas, defect);
  for(Chart::Point_2& p : atlas.uv) // where texels are squares
    p = Chart::Point_2(p.x(), p.y() / page_aspect);
  return atlas;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_CERTIFY_ATLAS_H
