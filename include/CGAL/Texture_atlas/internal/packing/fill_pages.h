// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Places charts of a given scale on as many pages as they need: each on the first page with room, the largest first.
// `pack_impl.h` runs it in place of the search for a scale. Places within a page come from `place_charts.h`.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_FILL_PAGES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_FILL_PAGES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/packing/charts_to_pack.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>
#include <CGAL/Texture_atlas/internal/packing/place_charts.h>
#include <CGAL/Texture_atlas/internal/packing/scaled_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Pages with charts
struct Filled_pages
{
  std::vector<Chart_place>
      places; // of each chart; empty if there would be too many pages, or a rule does not work
  int number_of_pages = 0;
  double texels_on_last = 0; // about those that its charts take
};

// Fills pages by one rule.
class Page_filler
{
public:
  // Each chart must fit on a page of its own.
  Page_filler(const Scaled_charts& scaled, const Placement_rule& rule) : m_scaled(scaled), m_rule(rule) {}

  Filled_pages run()
  {
    Filled_pages result;
    result.places.resize(static_cast<std::size_t>(m_scaled.charts().number_of_charts()));
    for(int c : m_scaled.largest_first())
      if(const std::optional<Chart_place> found = place(c))
        result.places[c] = *found;
      else
        return {};
    result.number_of_pages = static_cast<int>(m_pages.size());
    for(int c : m_scaled.largest_first())
      if(result.places[c].page + 1 == result.number_of_pages)
        result.texels_on_last += m_scaled.needed_texels(c);
    return result;
  }

private:
  static constexpr double as_large = 0.93; // A chart of this share of the size will find no place either.

  struct Page
  {
    Chart_placer placer;
    std::size_t free_cells; // at least
    double too_many_texels =
        (std::numeric_limits<double>::infinity)(); // A chart of that size found no place.
  };

  std::optional<Chart_place> place(int c)
  {
    const std::size_t cells = least_cells(c);
    const double texels = m_scaled.needed_texels(c);
    for(std::size_t i = 0; i < m_pages.size(); ++i)
      if(cells <= m_pages[i].free_cells && texels < as_large * m_pages[i].too_many_texels) {
        if(const std::optional<Chart_place> found = place_on(i, c))
          return found;
        m_pages[i].too_many_texels = texels;
      }
    if(m_pages.size() == most_pages)
      return std::nullopt;
    m_pages.push_back({Chart_placer(m_scaled, m_rule), 0});
    return place_on(m_pages.size() - 1, c);
  }

  std::optional<Chart_place> place_on(std::size_t i, int c)
  {
    std::optional<Chart_place> found = m_pages[i].placer.place(c);
    if(found) {
      found->page = static_cast<int>(i);
      m_pages[i].free_cells = m_pages[i].placer.number_of_free_cells();
    }
    return found;
  }

  std::size_t least_cells(int c) const
  {
    std::size_t least = (std::numeric_limits<std::size_t>::max)();
    for(int i = 0; i < m_scaled.number_of_directions(c); ++i)
      if(m_scaled.shape(c, i))
        least = (std::min)(least, m_scaled.shape(c, i)->cells.number_of_texels());
    return least;
  }

  const Scaled_charts& m_scaled;
  const Placement_rule m_rule;
  std::vector<Page> m_pages;
};

// With a given scale, the fewest pages of several rules; of these, those with the least on the last page
inline Filled_pages fill_pages(const Charts_to_pack& charts)
{
  const std::size_t most_rules = 16, least_rules = 4;
  const double few_tries = 4000; // of a chart on a page
  const bool are_few = charts.number_of_charts() * charts.number_of_pages() <= few_tries;
  const std::vector<int>& cells = charts.texels_of_cells();
  int cell = are_few ? cells.back() : cells[(std::min)(cells.size() - 1, std::size_t(1))];
  std::vector<std::vector<char>> is_allowed;
  for(int c = 0; c < charts.number_of_charts(); ++c) {
    is_allowed.emplace_back(charts.directions(c).size(), true);
    if(!charts.fits(c, cell))
      cell = 1;
  }
  Scaled_charts scaled(charts, is_allowed, charts.scale(), cell);
  scaled.make_shapes(std::vector<char>(charts.directions(scaled.largest_first().front()).size(), true));
  std::vector<Placement_rule> rules = placement_rules(charts);
  rules.resize((std::min)(rules.size(), are_few ? most_rules : least_rules));
  std::vector<Filled_pages> filled(rules.size());
  parallel_for(static_cast<int>(rules.size()),
               [&](int i) { filled[i] = Page_filler(scaled, rules[i]).run(); });
  return *std::min_element(filled.begin(), filled.end(), [](const Filled_pages& a, const Filled_pages& b) {
    return std::tuple(a.places.empty(), a.number_of_pages, a.texels_on_last) <
           std::tuple(b.places.empty(), b.number_of_pages, b.texels_on_last);
  });
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_FILL_PAGES_H
