// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The body of `pack()`: checks the input, reads the outlines, searches the scale, and turns places into similarities.
// `pack.h` includes it in programs without the compiled library, which otherwise has it in
// `angle_based_flattening_texture.cpp`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PACK_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PACK_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/certify_packing_impl.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/chart_outline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/pack.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/place_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/read_outlines.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/scaled_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/search_scale.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The sums of the areas of each chart. Sets the status and the chart where one is not a number of at least 0.
inline std::vector<double> areas_of_charts(const Triangles_of_charts& triangles,
                                           const std::vector<double>& area, Packing& packing)
{
  double largest = 0;
  for(double a : area)
    largest = (std::max)(largest, a);
  std::vector<double> sums(static_cast<std::size_t>(triangles.number_of_charts()), 0);
  for(int c = 0; c < triangles.number_of_charts() && packing.status == Packing::DONE; ++c)
    for(const int* t = triangles.begin(c); t != triangles.end(c); ++t) {
      if(!(area[*t] >= 0) || !std::isfinite(area[*t])) {
        packing.status = Packing::NON_FINITE;
        packing.chart = c;
      }
      sums[c] += largest > 0 ? area[*t] / largest : 0.;
    }
  if(packing.status == Packing::DONE && !(largest > 0))
    packing.status = Packing::NO_AREA;
  return sums;
}

inline void find_wrong_chart(const Triangles_of_charts& triangles, const std::vector<Planar_point>& corners,
                             Packing& packing)
{
  for(int c = 0; c < triangles.number_of_charts() && packing.status == Packing::DONE; ++c)
    for(const int* t = triangles.begin(c); t != triangles.end(c); ++t)
      for(int k = 0; k < 3; ++k)
        if(!corners[3 * *t + k].allFinite()) {
          packing.status = Packing::NON_FINITE;
          packing.chart = c;
        }
}

inline Similarity similarity(const Chart_outline& outline, const Chart_place& place, int resolution)
{
  Similarity result;
  result.cosine = place.cosine / resolution / outline.extent;
  result.sine = place.sine / resolution / outline.extent;
  result.origin = outline.origin;
  result.image = place.shift / resolution;
  return result;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Packing pack(const std::vector<Planar_point>& corners,
                                                const std::vector<int>& chart,
                                                const std::vector<double>& area, int number_of_charts,
                                                const Packing_options& options)
{
  Packing packing;
  if(!wrong_option(options).empty()) {
    packing.status = Packing::WRONG_OPTION;
    return packing;
  }
  const Triangles_of_charts triangles(chart, number_of_charts);
  find_wrong_chart(triangles, corners, packing);
  const std::vector<double> areas = areas_of_charts(triangles, area, packing);
  if(packing.status != Packing::DONE)
    return packing;
  const std::vector<Chart_outline> outlines = read_outlines(corners, triangles, areas);
  for(int c = 0; c < number_of_charts; ++c) {
    if(!outlines[c].has_area()) {
      packing.status = Packing::DEGENERATE_CHART;
      packing.chart = c;
      return packing;
    }
  }

  const Charts_to_pack charts(outlines, options);
  Scale_search search(charts);
  const bool is_found = search.run();
  packing.number_of_attempts = search.number_of_attempts();
  if(!is_found) {
    packing.status = Packing::TOO_MANY_CHARTS;
    return packing;
  }
  packing.texels_per_length = search.scale() / std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.)) /
                              std::sqrt(*std::max_element(area.begin(), area.end()));
  for(int c = 0; c < number_of_charts; ++c) {
    packing.placement.push_back(similarity(outlines[c], search.places()[c], options.resolution));
    const double scale = charts.scale_of(c, search.scale()) / options.resolution;
    packing.covered_share += outlines[c].area * scale * scale;
    packing.number_of_turned += charts.is_turned(c);
    packing.number_of_small += charts.is_small(c);
    packing.number_of_enlarged += charts.is_enlarged(c, search.scale());
  }
  return packing;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PACK_IMPL_H
