// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Places all charts at one scale, the largest first, each where a rule finds it lowest.
// `search_scale.h` tries scales and rules with it, `pack_impl.h` reads the places.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PLACE_CHARTS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PLACE_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/chart_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/occupied_cells.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/scaled_charts.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/texel_mask.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

struct Chart_place
{
  int direction = 0;
  double cosine = 1, sine = 0;               // times the scale, in texels
  Planar_point shift = Planar_point::Zero(); // in texels
};

// Places that are best by one rule need not leave good ones for the next charts: different rules are tried.
struct Placement_rule
{
  double height_weight = 1; // The row of the lower end counts, and the height times this number.
  int first_direction = -1; // that the largest chart has to take, or -1
};

// Places charts of one scale, the largest first, each where it is lowest.
class Chart_placer
{
public:
  Chart_placer(const Scaled_charts& scaled, const Placement_rule& rule)
      : m_scaled(scaled), m_rule(rule), m_gutter(scaled.charts().options().number_of_gutter_texels()),
        m_border((m_gutter + 1) / 2), m_cell(scaled.texels_of_cell()),
        m_margin((m_gutter + m_cell - 1) / m_cell),
        m_occupied((std::max)(0, scaled.charts().options().resolution - 2 * m_border) / m_cell, m_margin),
        m_places(static_cast<std::size_t>(scaled.charts().number_of_charts()))
  {}

  std::optional<std::vector<Chart_place>> run()
  {
    for(int c : m_scaled.largest_first())
      if(!place(c))
        return std::nullopt;
    return m_places;
  }

private:
  struct Choice
  {
    int direction = -1;
    Texel place{0, 0};
    double height = std::numeric_limits<double>::infinity();
  };

  bool place(int c)
  {
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
      return false;
    m_first_row = best.place.y;
    m_places[c].direction = best.direction;
    occupy(*m_scaled.shape(c, best.direction), best.place, m_places[c]);
    return true;
  }

  void look_for_better(int c, int direction, Choice& best)
  {
    if(!m_scaled.shape(c, direction))
      return;
    const Texel_mask& mask = m_scaled.shape(c, direction)->cells;
    const double height = m_rule.height_weight * mask.height();
    const std::optional<Texel> place =
        m_occupied.find_place(mask, m_first_row, [&](int y) { return y + height > best.height; });
    if(place && (place->y + height < best.height || place->x < best.place.x))
      best = {direction, *place, place->y + height};
  }

  // With the gutter
  void occupy(const Scaled_charts::Shape& scaled, const Texel& at, Chart_place& result)
  {
    const Chart_shape& shape = scaled.texels;
    m_occupied.add(m_cell == 1 ? dilated(scaled.cells, m_gutter) : shape.cells(m_cell, m_gutter, m_margin),
                   at.x, at.y);
    result.cosine = shape.cosine();
    result.sine = shape.sine();
    result.shift = shape.shift() + Planar_point(m_border + m_cell * at.x, m_border + m_cell * at.y);
  }

  const Scaled_charts& m_scaled;
  const Placement_rule m_rule;
  const int m_gutter, m_border; // texels between charts, and between them and the border of the square
  const int m_cell;             // texels along the side of a cell
  const int m_margin;           // cells that the gutter may stick out
  Occupied_cells m_occupied;
  std::vector<Chart_place> m_places;
  double m_texels_at_first_row = 0; // that the chart needed which was tried from the first row on
  int m_first_row = 0;              // where the next alike is tried
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PLACE_CHARTS_H
