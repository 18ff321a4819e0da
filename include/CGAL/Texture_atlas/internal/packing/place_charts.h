// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Places all charts at one scale, the largest first, each where a rule finds it lowest.
// `search_scale.h` tries scales and rules with it, `fill_pages.h` fills one page after the other, and `pack_impl.h`
// reads the places.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PLACE_CHARTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PLACE_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/packing/chart_shape.h>
#include <CGAL/Texture_atlas/internal/packing/charts_to_pack.h>
#include <CGAL/Texture_atlas/internal/packing/occupied_cells.h>
#include <CGAL/Texture_atlas/internal/packing/scaled_charts.h>
#include <CGAL/Texture_atlas/internal/packing/texel_mask.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Texture_atlas::internal {

struct Chart_place
{
  int direction = 0;
  int page = 0;
  double cosine = 1, sine = 0;               // times the scale, in texels
  Planar_point shift = Planar_point::Zero(); // in texels
};

// Places that are best by one rule need not leave good ones for the next charts: different rules are tried.
struct Placement_rule
{
  double height_weight = 1; // The row of the lower end counts, and the height times this number.
  int first_direction = -1; // that the largest chart has to take, or -1
};

// The more charts, the fewer rules
inline std::vector<Placement_rule> placement_rules(const Charts_to_pack& charts)
{
  const double height_weights[] = {1, 0.5, 1.5, 0};
  int directions = 0, most = 0;
  for(int c = 0; c < charts.number_of_charts(); ++c) {
    const int number = static_cast<int>(charts.directions(c).size());
    directions += number;
    most = (std::max)(most, 4 * (1 + number));
  }
  std::vector<Placement_rule> result;
  const int tries = 1 << 15, many_directions = 1 << 13, least = directions > many_directions ? 4 : 10;
  const int number =
      charts.number_of_charts() == 1 ? 1 : (std::min)(most, (std::max)(least, tries / directions));
  for(int i = 0; i < number; ++i)
    result.push_back({height_weights[i % 4], i / 4 - 1});
  return result;
}

// Places charts of one scale, the largest first, each where it is lowest.
class Chart_placer
{
public:
  Chart_placer(const Scaled_charts& scaled, const Placement_rule& rule)
      : m_scaled(scaled), m_rule(rule), m_gutter(scaled.charts().options().number_of_gutter_texels()),
        m_border((m_gutter + 1) / 2), m_cell(scaled.texels_of_cell()),
        m_margin((m_gutter + m_cell - 1) / m_cell),
        m_occupied((std::max)(0, scaled.charts().options().resolution - 2 * m_border) / m_cell,
                   (std::max)(0, scaled.charts().options().number_of_rows() - 2 * m_border) / m_cell,
                   m_margin)
  {}

  // All charts on one page, if it holds them
  std::optional<std::vector<Chart_place>> run()
  {
    std::vector<Chart_place> places(static_cast<std::size_t>(m_scaled.charts().number_of_charts()));
    for(int c : m_scaled.largest_first())
      if(const std::optional<Chart_place> found = place(c))
        places[c] = *found;
      else
        return std::nullopt;
    return places;
  }

  // The place that a chart takes, if there is one
  std::optional<Chart_place> place(int c)
  {
    Deadline::ask();
    const double texels = m_scaled.needed_texels(c);
    if(!m_scaled.charts().is_small(c) || texels < alike * m_texels_at_first_row) {
      m_texels_at_first_row = texels;
      m_first_row = 0;
    }
    const bool is_first = c == m_scaled.largest_first().front();
    Choice best;
    for(int i = 0; i < m_scaled.number_of_directions(c); ++i)
      if(!is_first || m_rule.first_direction < 0 || i == m_rule.first_direction)
        look_for_better(c, i, best);
    if(best.direction < 0)
      return std::nullopt;
    m_first_row = best.place.y;
    return occupy(c, best.direction, best.place);
  }

  // At least those of the page that are free
  std::size_t number_of_free_cells() const { return m_occupied.number_of_free_cells(); }

private:
  struct Choice
  {
    int direction = -1;
    Texel place{0, 0};
    double height = std::numeric_limits<double>::infinity();
  };

  void look_for_better(int c, int direction, Choice& best)
  {
    if(!m_scaled.shape(c, direction))
      return;
    const Scaled_charts::Shape& shape = *m_scaled.shape(c, direction);
    const double height = m_rule.height_weight * shape.cells.height();
    const int last_row =
        static_cast<int>((std::min)(std::floor(best.height - height), double(largest_resolution)));
    const std::optional<Texel> place = m_occupied.find_place(shape.cells, shape.runs, m_first_row, last_row);
    if(place && (place->y + height < best.height || place->x < best.place.x))
      best = {direction, *place, place->y + height};
  }

  // With the gutter
  Chart_place occupy(int c, int direction, const Texel& at)
  {
    const Scaled_charts::Shape& scaled = *m_scaled.shape(c, direction);
    const Chart_shape& shape = scaled.texels;
    m_occupied.add(scaled.cells_with_gutter(m_gutter, m_margin), at.x, at.y);
    Chart_place result;
    result.direction = direction;
    result.cosine = shape.cosine();
    result.sine = shape.sine();
    result.shift = shape.shift() + Planar_point(m_border + m_cell * at.x, m_border + m_cell * at.y);
    return result;
  }

  const Scaled_charts& m_scaled;
  const Placement_rule m_rule;
  const int m_gutter, m_border; // texels between charts, and between them and the border of the page
  const int m_cell;             // texels along the side of a cell
  const int m_margin;           // cells that the gutter may stick out
  Occupied_cells m_occupied;
  double m_texels_at_first_row = 0; // that the chart needed which was tried from the first row on
  int m_first_row = 0;              // where the next alike is tried
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_PLACE_CHARTS_H
