// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Certifies the charts of a part with their final, rounded coordinates. Packing moves and scales charts, so earlier
// tests do not count. `build_atlas_impl.h` makes parts anew that fail.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_CERTIFY_ATLAS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_CERTIFY_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/atlas/part_atlas.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>

#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The border edges of each chart of a part
inline std::vector<std::vector<Border_edge>> borders_of_pieces(const Part_atlas& part)
{
  std::vector<std::vector<Border_edge>> borders(part.pieces.size());
  for(const std::vector<int>& border : part.chart.borders)
    for(int c : border)
      borders[part.piece[c / 3]].push_back({part.chart.edge_source(c), part.chart.edge_target(c)});
  return borders;
}

// Returns why the map of a chart is not injective, by exact predicates, or nothing.
inline std::string certify_part(const Part_atlas& part)
{
  const Chart& chart = part.chart;
  const std::vector<Exact_point_2> uv = exact_points(part.uv);
  const std::vector<int> flipped = flipped_triangles(chart.vertex, uv);
  if(!flipped.empty())
    return "the final coordinates have too few digits for " + std::to_string(flipped.size()) +
           " triangle(s), one at the vertex at " + position_text(chart, chart.vertex[3 * flipped.front()]);
  for(const std::vector<Border_edge>& border : borders_of_pieces(part))
    if(!bounds_region(border, uv))
      return "the final coordinates have too few digits for the border at the vertex at " +
             position_text(chart, border.front().source);
  return "";
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_CERTIFY_ATLAS_H
