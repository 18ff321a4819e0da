// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The search for the largest scale at which all charts find a place, with coarse cells first and finer ones later.
// `pack_impl.h` runs it. There is no guarantee that smaller scales fit too, so it climbs on after bisection.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_SEARCH_SCALE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_SEARCH_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/place_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/scaled_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Searches the largest scale with places for all charts. Smaller scales need not fit: the largest scale that was tried
// and fits counts.
class Scale_search
{
public:
  // The areas of the charts are 1 together.
  explicit Scale_search(const Charts_to_pack& charts)
      : m_charts(charts), m_side(charts.side_of_page()), m_rules(placement_rules(charts))
  {
    double largest = 0;
    for(int c = 0; c < charts.number_of_charts(); ++c)
      largest = (std::max)(largest, charts.outline(c).length);
    m_least = least_extent / largest;
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
      if(!m_places.empty())
        climb();
      else if(bracket())
        try_all_rules();
      if(!m_places.empty() && cell != m_charts.texels_of_cells().back())
        keep_best_rules(cell == m_charts.texels_of_cells().front() ? 8 : 4);
    }
    if(m_places.empty())
      return false;
    for(double step = (precision - 1) / 2; step > last_step; step /= 2)
      attempt(m_scale * (1 + step), m_best_rule, m_best_rule + 1);
    return true;
  }

  double scale() const { return m_scale; } // the texels of the length 1
  int number_of_attempts() const { return m_attempts; }
  const std::vector<Chart_place>& places() const { return m_places; }

private:
  static constexpr double precision = 1.003, first_step = 0.06, last_step = 0.0004;
  static constexpr std::size_t rules_of_bisection = 2, rules_at_once = 8;

  // With large cells, all rules and directions are tried, and with smaller ones those that were best or nearly so.
  static constexpr double nearly = 0.99;

  // Sets a scale that fits, and one above that does not, if there is one.
  bool bracket()
  {
    const std::size_t rules = (std::min)(rules_of_bisection, m_rules.size());
    double scale = (std::max)(scale_of_needed_share(0.8), m_least);
    if(attempt(scale, 0, rules)) {
      for(double step = first_step; m_scale < m_side; step *= 2) {
        m_above = (std::min)((1 + step) * m_scale, m_side);
        if(!attempt(m_above, 0, rules))
          return true;
      }
      m_above = m_scale;
      return true;
    }
    for(double step = first_step; scale > m_least; step *= 2) {
      m_above = scale;
      scale = (std::max)(scale / (1 + step), m_least);
      if(attempt(scale, 0, rules))
        return true;
    }
    return false;
  }

  void try_all_rules()
  {
    const std::size_t first = (std::min)(rules_of_bisection, m_rules.size());
    bisect(first);
    for(std::size_t i = first; i < m_rules.size(); i += rules_at_once) {
      const std::size_t end = (std::min)(i + rules_at_once, m_rules.size());
      for(double step = precision - 1; attempt(m_scale * (1 + step), i, end);)
        step *= 2;
    }
  }

  void bisect(std::size_t rules)
  {
    while(m_above > precision * m_scale)
      if(const double middle = std::sqrt(m_above * m_scale); !attempt(middle, 0, rules))
        m_above = middle;
  }

  // From the scale for which there are places already
  void climb()
  {
    double step = precision - 1;
    for(m_above = (1 + step) * m_scale; attempt(m_above, 0, m_rules.size()); m_above = (1 + step) * m_scale)
      step *= 2;
    bisect(m_rules.size());
  }

  // That many, and at most half of them
  void keep_best_rules(std::size_t most)
  {
    most = (std::min)(most, (m_rules.size() + 1) / 2);
    const auto places = places_by_rules(nearly * m_scale);
    std::vector<Placement_rule> best = {m_rules[m_best_rule]};
    forbid_turning();
    allow_directions(m_places);
    for(std::size_t i = 0; i < m_rules.size() && best.size() < most; ++i)
      if(i != m_best_rule && places[i]) {
        best.push_back(m_rules[i]);
        allow_directions(*places[i]);
      }
    m_rules = std::move(best);
    m_best_rule = 0;
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
    if(const auto found = static_cast<std::size_t>(first); found < places.size()) {
      m_places = std::move(*places[found]);
      m_scale = scale;
      m_best_rule = begin + found;
      return true;
    }
    return false;
  }

  // The places by each of the rules, if all charts fit
  std::vector<std::optional<std::vector<Chart_place>>> places_by_rules(double scale)
  {
    prepare(scale, 0, m_rules.size());
    std::vector<std::optional<std::vector<Chart_place>>> places(m_rules.size());
    parallel_for(static_cast<int>(places.size()),
                 [&](int i) { places[i] = Chart_placer(*m_scaled, m_rules[i]).run(); });
    return places;
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

  // The scale at which charts need about this share of the texels; near 0 if they always need more
  double scale_of_needed_share(double share) const
  {
    double lower = 0, upper = m_side;
    for(int i = 0; i < 40; ++i) {
      const double scale = (lower + upper) / 2;
      double texels = 0;
      for(int c = 0; c < m_charts.number_of_charts(); ++c)
        texels += m_charts.needed_texels(c, scale);
      (texels < share * m_side * m_side ? lower : upper) = scale;
    }
    return lower;
  }

  const Charts_to_pack& m_charts;
  const double m_side; // of a square of the size of the page
  std::vector<Placement_rule> m_rules;
  int m_cell = 1;     // texels along the side of a cell
  double m_least = 0; // of which no chart is larger than the least extent
  double m_scale = 0, m_above = 0;
  std::size_t m_best_rule = 0;
  int m_attempts = 0;
  std::vector<std::vector<char>> m_is_allowed; // of each chart, each direction
  std::optional<Scaled_charts> m_scaled;       // of the last attempt: the next one may have the same scale
  std::vector<Chart_place> m_places;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_SEARCH_SCALE_H
