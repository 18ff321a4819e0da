// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The charts of a packing at one scale: their order, and masks of their cells in all directions.
// `place_charts.h` takes the masks from it. `search_scale.h` keeps those of the last scale, as the next attempt may
// have the same.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_SCALED_CHARTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_SCALED_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/packing/chart_shape.h>
#include <CGAL/Texture_atlas/internal/packing/charts_to_pack.h>
#include <CGAL/Texture_atlas/internal/packing/texel_mask.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The charts at one scale, in all directions, the largest first, and the cells of `cell`^2 texels that they touch
class Scaled_charts
{
public:
  class Shape
  {
  public:
    Shape(const Chart_shape& texels, int cell, Texel_mask&& cells)
        : texels(texels), cells(std::move(cells)), runs(longest_runs(this->cells)), m_cell(cell)
    {}

    // The cells with those that are as near as the gutter, in a mask that is larger by `margin` on all sides. It is made
    // when a rule needs it first.
    const Texel_mask& cells_with_gutter(int gutter, int margin) const
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      if(!m_with_gutter)
        m_with_gutter.emplace(m_cell == 1 ? dilated(cells, gutter) : texels.cells(m_cell, gutter, margin));
      return *m_with_gutter;
    }

    const Chart_shape texels;
    const Texel_mask cells;
    const std::vector<Row_run> runs; // of some rows of the cells
  private:
    const int m_cell;
    mutable std::mutex m_mutex;
    mutable std::optional<Texel_mask> m_with_gutter;
  };

  // `is_allowed` tells the directions to try of each chart.
  Scaled_charts(const Charts_to_pack& charts, const std::vector<std::vector<char>>& is_allowed, double scale,
                int cell)
      : m_charts(charts), m_is_allowed(is_allowed), m_scale(scale), m_cell(cell)
  {
    sort();
    for(int c = 0; c < charts.number_of_charts(); ++c)
      m_shapes.emplace_back(charts.directions(c).size());
  }

  // Makes missing shapes: of the largest chart in those of the allowed directions that are wanted, of other charts in
  // all allowed ones.
  void make_shapes(const std::vector<char>& is_wanted)
  {
    std::vector<Turned_shapes> missing;
    for(int c : m_order)
      for(const std::vector<int>& directions : m_charts.quarter_turns(c)) {
        Turned_shapes shapes{c, {}};
        for(std::size_t turns = 0; turns < directions.size(); ++turns)
          if(const int i = directions[turns];
             !m_shapes[c][i] && m_is_allowed[c][i] && (c == m_order.front() ? is_wanted[i] : !m_is_made))
            shapes.directions.emplace_back(i, static_cast<int>(turns));
        if(!shapes.directions.empty())
          missing.push_back(std::move(shapes));
      }
    parallel_for(static_cast<int>(missing.size()), [&](int i) { make_shapes(missing[i]); });
    m_is_made = true;
  }

  const Charts_to_pack& charts() const { return m_charts; }
  double scale() const { return m_scale; }
  int texels_of_cell() const { return m_cell; }
  const std::vector<int>& largest_first() const { return m_order; }
  double needed_texels(int c) const { return m_charts.needed_texels(c, m_scale); }
  int number_of_directions(int c) const { return static_cast<int>(m_shapes[c].size()); }

  // None if it is larger than the page, or the direction is not allowed
  const std::optional<Shape>& shape(int c, int direction) const { return m_shapes[c][direction]; }

private:
  // Of a chart, in directions that differ by right angles
  struct Turned_shapes
  {
    int chart;
    std::vector<std::pair<int, int>> directions; // with the number of right angles
  };

  // One is drawn, and the others are made from it.
  void make_shapes(const Turned_shapes& shapes)
  {
    auto [first, turns] = shapes.directions.front();
    Chart_shape texels(m_charts.outline(shapes.chart), m_charts.directions(shapes.chart)[first],
                       m_charts.scale_of(shapes.chart, m_scale), largest_border_move(m_charts.options()));
    std::optional<Texel_mask> cells;
    for(const auto& [direction, wanted_turns] : shapes.directions) {
      for(; turns < wanted_turns; ++turns) {
        texels = texels.quarter_turn(m_cell);
        if(cells)
          cells = quarter_turn(*cells);
      }
      if(!texels.fits(m_charts.options().resolution, m_charts.options().number_of_rows()))
        continue;
      if(!cells)
        cells = texels.cells(m_cell);
      m_shapes[shapes.chart][direction].emplace(texels, m_cell, Texel_mask(*cells));
    }
  }

  // By the areas of the hulls: a ring comes before what may be put inside it.
  void sort()
  {
    std::vector<double> size;
    for(int c = 0; c < m_charts.number_of_charts(); ++c) {
      const double scale = m_charts.scale_of(c, m_scale);
      size.push_back(m_charts.outline(c).hull_area * scale * scale);
    }
    m_order.resize(size.size());
    std::iota(m_order.begin(), m_order.end(), 0);
    std::stable_sort(m_order.begin(), m_order.end(), [&](int a, int b) { return size[a] > size[b]; });
  }

  const Charts_to_pack& m_charts;
  const std::vector<std::vector<char>>& m_is_allowed;
  double m_scale;
  int m_cell;
  bool m_is_made = false; // of the charts but the largest one
  std::vector<int> m_order;
  std::vector<std::vector<std::optional<Shape>>> m_shapes; // of each chart, in each direction
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_SCALED_CHARTS_H
