// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The body of `pack()`: checks the input, reads the outlines, searches the scale or fills pages, and turns places into
// similarities.
// `pack.h` includes it in programs without the compiled library, which otherwise has it in
// `angle_based_flattening_texture.cpp`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACK_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACK_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/packing/certify_packing_impl.h>
#include <CGAL/Texture_atlas/internal/packing/chart_outline.h>
#include <CGAL/Texture_atlas/internal/packing/charts_to_pack.h>
#include <CGAL/Texture_atlas/internal/packing/fill_pages.h>
#include <CGAL/Texture_atlas/internal/packing/pack.h>
#include <CGAL/Texture_atlas/internal/packing/place_charts.h>
#include <CGAL/Texture_atlas/internal/packing/quantize.h>
#include <CGAL/Texture_atlas/internal/packing/read_outlines.h>
#include <CGAL/Texture_atlas/internal/packing/scaled_charts.h>
#include <CGAL/Texture_atlas/internal/packing/search_scale.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

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

inline Similarity similarity(const Chart_outline& outline, const Chart_place& place,
                             const Packing_options& options)
{
  Similarity result;
  result.cosine = place.cosine / options.resolution / outline.extent;
  result.sine = place.sine / options.resolution / outline.extent;
  result.origin = outline.origin;
  result.image = place.shift / options.resolution;
  result.aspect = aspect_ratio(options);
  result.corner = corner_of_page(place.page);
  return result;
}

// The places of all charts at the largest scale that is found, which is returned; 0 if there is none
inline double search_scale(const Charts_to_pack& charts, double least_share, std::vector<Chart_place>& places,
                           Packing& packing)
{
  Scale_search search(charts, least_share);
  const bool is_found = search.run();
  packing.number_of_attempts = search.number_of_attempts();
  if(!is_found) {
    packing.status = Packing::TOO_MANY_CHARTS;
    return 0;
  }
  places = search.places();
  return search.scale();
}

// The charts that no page can hold at the given scale
inline std::vector<int> charts_too_large(const Charts_to_pack& charts)
{
  std::vector<int> result;
  for(int c = 0; c < charts.number_of_charts(); ++c)
    if(!charts.fits(c, 1))
      result.push_back(c);
  return result;
}

// The places of all charts at the given scale, on as many pages as they need
inline void fill_pages(const Charts_to_pack& charts, std::vector<Chart_place>& places, Packing& packing)
{
  packing.number_of_pages = std::ceil(charts.number_of_pages());
  if(packing.number_of_pages > most_pages) {
    packing.status = Packing::TOO_MANY_PAGES;
    return;
  }
  if(const std::vector<int> too_large = charts_too_large(charts); !too_large.empty()) {
    packing.status = Packing::CHART_TOO_LARGE;
    packing.chart = too_large.front();
    const Chart_outline& outline = charts.outline(packing.chart);
    packing.texels = charts.scale_of(packing.chart, charts.scale()) *
                     turned_extent(outline.hull, outline.angle_of_rectangle);
    return;
  }
  Filled_pages filled = fill_pages(charts);
  packing.number_of_attempts = 1;
  if(filled.places.empty()) {
    packing.status = Packing::TOO_MANY_PAGES;
    packing.number_of_pages = most_pages + 1;
    return;
  }
  packing.number_of_pages = filled.number_of_pages;
  places = std::move(filled.places);
}

inline void set_placement(const std::vector<Chart_outline>& outlines, const Charts_to_pack& charts,
                          const std::vector<Chart_place>& places, double scale, Packing& packing)
{
  for(int c = 0; c < charts.number_of_charts(); ++c) {
    packing.placement.push_back(similarity(outlines[c], places[c], charts.options()));
    packing.page.push_back(places[c].page);
    packing.scale.push_back(
        charts.is_reduced(c, scale) ? charts.scale_of(c, scale) / (charts.outline(c).length * scale) : 1);
    const double size = charts.scale_of(c, scale) / charts.options().resolution;
    packing.covered_share += outlines[c].area * size * size;
    packing.number_of_turned += charts.is_turned(c);
    packing.number_of_small += charts.is_small(c);
    packing.number_of_enlarged += charts.is_enlarged(c, scale);
  }
  packing.covered_share *= aspect_ratio(charts.options()) / packing.number_of_pages;
}

// The outlines of all charts, or what is wrong with them. The area of all charts is the square of both roots.
inline std::vector<Chart_outline> checked_outlines(const std::vector<Planar_point>& corners,
                                                   const std::vector<int>& chart,
                                                   const std::vector<double>& area, int number_of_charts,
                                                   std::pair<double, double>& roots, Packing& packing)
{
  const Triangles_of_charts triangles(chart, number_of_charts);
  find_wrong_chart(triangles, corners, packing);
  const std::vector<double> areas = areas_of_charts(triangles, area, packing);
  if(packing.status != Packing::DONE)
    return {};
  roots = {std::sqrt(std::accumulate(areas.begin(), areas.end(), 0.)),
           std::sqrt(*std::max_element(area.begin(), area.end()))};
  std::vector<Chart_outline> outlines = read_outlines(corners, triangles, areas);
  for(int c = 0; c < number_of_charts && packing.status == Packing::DONE; ++c)
    if(!outlines[c].has_area()) {
      packing.status = Packing::DEGENERATE_CHART;
      packing.chart = c;
    }
  return outlines;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Packing pack(const std::vector<Planar_point>& corners,
                                                const std::vector<int>& chart,
                                                const std::vector<double>& area, int number_of_charts,
                                                const Packing_options& options, double least_share)
{
  Packing packing;
  if(!wrong_option(options).empty()) {
    packing.status = Packing::WRONG_OPTION;
    return packing;
  }
  std::pair<double, double> roots;
  const std::vector<Chart_outline> outlines =
      checked_outlines(corners, chart, area, number_of_charts, roots, packing);
  if(packing.status != Packing::DONE)
    return packing;
  const Packing_options blocks = in_blocks(options);
  double scale = blocks.texels_per_unit * roots.first * roots.second;
  const Charts_to_pack charts(outlines, blocks, scale);
  std::vector<Chart_place> places;
  if(scale > 0)
    fill_pages(charts, places, packing);
  else
    scale = search_scale(charts, least_share, places, packing);
  packing.texels *= options.block;
  if(packing.status != Packing::DONE)
    return packing;
  packing.texels_per_length = scale / roots.first / roots.second * options.block;
  set_placement(outlines, charts, places, scale, packing);
  return packing;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<int>
charts_too_large(const std::vector<Planar_point>& corners, const std::vector<int>& chart,
                 const std::vector<double>& area, int number_of_charts, const Packing_options& options)
{
  Packing packing;
  std::pair<double, double> roots;
  const std::vector<Chart_outline> outlines =
      checked_outlines(corners, chart, area, number_of_charts, roots, packing);
  if(packing.status != Packing::DONE)
    return {};
  const Packing_options blocks = in_blocks(options);
  const Charts_to_pack charts(outlines, blocks, blocks.texels_per_unit * roots.first * roots.second);
  return charts.number_of_pages() > most_pages ? std::vector<int>() : charts_too_large(charts);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE void quantize(const std::vector<int>& vertex, int bits,
                                                 std::vector<Chart::Point_2>& uv)
{
  Chart_quantizer(vertex, bits, uv).run();
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PACK_IMPL_H
