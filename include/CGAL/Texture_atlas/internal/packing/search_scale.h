// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The search for the largest scale at which all charts find a place, with coarse cells first and finer ones later.
// `pack_impl.h` runs it. There is no guarantee that smaller scales fit too, so larger ones are tried after bisection.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_SEARCH_SCALE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_SEARCH_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/packing/charts_to_pack.h>
#include <CGAL/Texture_atlas/internal/packing/place_charts.h>
#include <CGAL/Texture_atlas/internal/packing/scaled_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Searches the largest scale with places for all charts. Smaller scales need not fit: the largest scale that was tried
// and fits counts.
class Scale_search
{
public:
  // The areas of the charts are 1 together. Charts that cover no more than `least_share` of the page are not wanted.
  Scale_search(const Charts_to_pack& charts, double least_share)
      : m_charts(charts), m_side(charts.side_of_page()),
        m_wanted(m_side * std::sqrt(least_share) * (1 + last_step)), m_rules(placement_rules(charts))
  {
    double largest = 0;
    for(int c = 0; c < charts.number_of_charts(); ++c)
      largest = (std::max)(largest, charts.outline(c).length);
    m_least = charts.least_extent() / largest;
    for(int c = 0; c < charts.number_of_charts(); ++c)
      m_is_allowed.emplace_back(charts.directions(c).size(), true);
  }

  // Returns whether there is one.
  bool run()
  {
    const int gutter = m_charts.options().number_of_gutter_texels();
    const double width = m_charts.options().resolution + gutter,
                 height = m_charts.options().number_of_rows() + gutter, least = 1. + gutter;
    if(m_charts.number_of_charts() * least * least > width * height)
      return false;
    for(int cell : m_charts.texels_of_cells()) {
      m_cell = cell;
      if(!m_found.empty()) {
        keep_best_rules();
        increase(0, m_rules.size(), precision - 1);
      } else if(const std::size_t tried = m_wanted > 0 ? increase_from_wanted() : bisect_usual(); tried > 0)
        try_rules_from(tried);
    }
    if(m_found.empty())
      return false;
    for(double step = (precision - 1) / 2; step > last_step; step /= 2)
      attempt(m_scale * (1 + step), 0, m_rules.size());
    return true;
  }

  double scale() const { return m_scale; } // the texels of the length 1
  int number_of_attempts() const { return m_attempts; }
  const std::vector<Chart_place>& places() const { return m_found.front().places; }

private:
  static constexpr double rough_precision = 1.015, precision = 1.003, first_step = 0.04, last_step = 0.0004;
  static constexpr double usual_share = 0.75; // of the texels that charts need
  static constexpr std::size_t rules_at_once = 16, best_rules = 4;

  struct Found
  {
    std::size_t rule;
    std::vector<Chart_place> places;
  };

  // Returns the number of rules that were tried; none if no scale fits.
  std::size_t bisect_usual()
  {
    const std::size_t rules = (std::min)(rules_at_once, m_rules.size());
    double scale = (std::max)(m_charts.scale_of_needed_share(usual_share), m_least);
    if(attempt(scale, 0, rules)) {
      increase(0, rules, first_step);
      return rules;
    }
    for(double step = first_step; scale > m_least; step *= 2) {
      m_above = scale;
      scale = (std::max)(scale / (1 + step), m_least);
      if(attempt(scale, 0, rules)) {
        bisect(0, rules);
        return rules;
      }
    }
    return 0;
  }

  // The same for scales that are large enough. Rules that do not fit at the wanted scale are not tried at larger ones.
  std::size_t increase_from_wanted()
  {
    if(!attempt(m_wanted, 0, m_rules.size()))
      return 0;
    const std::size_t first = m_found.front().rule, end = (std::min)(first + rules_at_once, m_rules.size());
    increase(first, end, precision - 1);
    return end;
  }

  // Each counts at the largest scale that was found before.
  void try_rules_from(std::size_t first)
  {
    for(std::size_t i = first; i < m_rules.size(); i += rules_at_once) {
      const std::size_t end = (std::min)(i + rules_at_once, m_rules.size());
      for(double step = precision - 1; attempt(m_scale * (1 + step), i, end);)
        step *= 2;
    }
  }

  // To the limit only if no other rules follow, which find larger scales mostly
  void bisect(std::size_t begin, std::size_t end)
  {
    const double enough = end == m_rules.size() ? precision : rough_precision;
    while(m_above > enough * m_scale)
      if(const double middle = std::sqrt(m_above * m_scale); !attempt(middle, begin, end))
        m_above = middle;
  }

  // From the scale for which there are places already
  void increase(std::size_t begin, std::size_t end, double step)
  {
    for(m_above = (1 + step) * m_scale; attempt(m_above, begin, end); m_above = (1 + step) * m_scale)
      step *= 2;
    bisect(begin, end);
  }

  // Those that found places at the largest scales; charts may take directions as there.
  void keep_best_rules()
  {
    std::vector<Placement_rule> best;
    forbid_turning();
    for(Found& found : m_found) {
      best.push_back(m_rules[found.rule]);
      found.rule = best.size() - 1;
      allow_directions(found.places);
    }
    m_rules = std::move(best);
  }

  // Charts that are tried in few directions keep them.
  void forbid_turning()
  {
    for(int c = 0; c < m_charts.number_of_charts(); ++c)
      if(m_charts.is_turned(c))
        m_is_allowed[c].assign(m_is_allowed[c].size(), false);
  }

  // Those of some places, and the next ones on both sides. Direction 0 is not one of the circle, if there are others.
  void allow_directions(const std::vector<Chart_place>& places)
  {
    for(int c = 0; c < m_charts.number_of_charts(); ++c) {
      const int direction = places[c].direction, circle = static_cast<int>(m_is_allowed[c].size()) - 1;
      m_is_allowed[c][direction] = true;
      if(m_charts.is_turned(c) && direction > 0)
        for(const int step : {1, circle - 1})
          m_is_allowed[c][1 + (direction - 1 + step) % circle] = true;
    }
  }

  // Whether all fit by one of the rules: the first of those counts, whatever the order in time. Rules behind it need
  // not be tried.
  bool attempt(double scale, std::size_t begin, std::size_t end)
  {
    prepare(scale, begin, end);
    std::vector<std::optional<std::vector<Chart_place>>> places(end - begin);
    std::atomic<int> first{static_cast<int>(places.size())};
    parallel_for(static_cast<int>(places.size()), [&](int i) {
      if(i > first)
        return;
      places[i] = Chart_placer(*m_scaled, m_rules[begin + i]).run();
      for(int least = first; places[i] && i < least && !first.compare_exchange_weak(least, i);)
        ;
    });
    const auto found = static_cast<std::size_t>(first);
    if(found == places.size())
      return false;
    m_scale = scale;
    remember({begin + found, std::move(*places[found])});
    return true;
  }

  void remember(Found&& found)
  {
    m_found.erase(
        std::remove_if(m_found.begin(), m_found.end(), [&](const Found& f) { return f.rule == found.rule; }),
        m_found.end());
    m_found.insert(m_found.begin(), std::move(found));
    if(m_found.size() > best_rules)
      m_found.pop_back();
  }

  void prepare(double scale, std::size_t begin, std::size_t end)
  {
    ++m_attempts;
    if(!m_scaled || m_scaled->scale() != scale || m_scaled->texels_of_cell() != m_cell)
      m_scaled.emplace(m_charts, m_is_allowed, scale, m_cell);
    m_scaled->make_shapes(directions_of_largest(begin, end));
  }

  // Whether the rules allow them for the largest chart
  std::vector<char> directions_of_largest(std::size_t begin, std::size_t end) const
  {
    const std::size_t directions = m_charts.directions(m_scaled->largest_first().front()).size();
    std::vector<char> is_wanted(directions, false);
    for(std::size_t i = begin; i < end; ++i)
      if(const int direction = m_rules[i].first_direction; direction < 0)
        is_wanted.assign(directions, true);
      else if(static_cast<std::size_t>(direction) < directions)
        is_wanted[direction] = true;
    return is_wanted;
  }

  const Charts_to_pack& m_charts;
  const double m_side;   // of a square of the size of the page
  const double m_wanted; // the least scale, or 0
  std::vector<Placement_rule> m_rules;
  int m_cell = 1;     // texels along the side of a cell
  double m_least = 0; // of which no chart is larger than the least extent
  double m_scale = 0, m_above = 0;
  int m_attempts = 0;
  std::vector<std::vector<char>> m_is_allowed; // of each chart, each direction
  std::optional<Scaled_charts> m_scaled;       // of the last attempt: the next one may have the same scale
  std::vector<Found> m_found; // with different rules, at the largest scales: the last one first
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_SEARCH_SCALE_H
