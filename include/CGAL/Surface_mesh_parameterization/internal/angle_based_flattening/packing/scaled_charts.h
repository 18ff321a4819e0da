// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The charts of a packing before and after they have a scale: directions to try, order, and masks of their cells.
// `place_charts.h` takes the masks from it. `search_scale.h` keeps those of the last scale, as the next attempt may
// have the same.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_SCALED_CHARTS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_SCALED_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/chart_outline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/chart_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/packing.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/texel_mask.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/turned_mask.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A chart is not made smaller than that, in texels.
inline constexpr double least_extent = 1. / 16;

// All directions are tried for charts of at least this share of the area, four for others and along axes.
inline constexpr double least_turned_share = 0.02;

// Of charts with less than that share, the next one is not tried in rows where the last one had no place, until charts
// are smaller by `alike`.
inline constexpr double largest_small_share = 0.002, alike = 0.75;

// The charts before they have a scale
class Charts_to_pack
{
public:
  // `scale` are the texels of the length 1 if charts have that scale, or 0. Options have blocks of one texel.
  Charts_to_pack(const std::vector<Chart_outline>& outlines, const Packing_options& options, double scale = 0)
      : m_outlines(outlines), m_options(options), m_scale(scale),
        m_pages((std::max)(1., scale / side_of_page() * (scale / side_of_page())))
  {
    const double texels_of_chart = side_of_page() / std::sqrt(static_cast<double>(outlines.size()) / m_pages);
    for(const auto& [cells, cells_of_chart] : finenesses)
      if(const int cell = (std::max)(1, static_cast<int>((std::min)(std::ceil(side_of_page() / cells),
                                                                    texels_of_chart / cells_of_chart)));
         m_cells.empty() || cell < m_cells.back())
        m_cells.push_back(cell);
    for(int c = 0; c < number_of_charts(); ++c) {
      m_is_turned.push_back(share(c) >= least_turned_share && !keeps_axes(c));
      m_angles.push_back(angles(c));
      if(scale > 0 && m_pages <= most_pages && !m_is_turned[c] && !fits(c, 1)) {
        m_is_turned[c] = true;
        m_angles[c] = angles(c);
      }
    }
  }

  int number_of_charts() const { return static_cast<int>(m_outlines.size()); }
  const Chart_outline& outline(int c) const { return m_outlines[c]; }
  const std::vector<double>& directions(int c) const { return m_angles[c]; }
  const Packing_options& options() const { return m_options; }

  // The numbers of all directions: those that differ by right angles are together, counterclockwise.
  std::vector<std::vector<int>> quarter_turns(int c) const
  {
    const int directions = static_cast<int>(m_angles[c].size()), first = is_turned(c) && directions > 1,
              turns = (directions - first) % 4 == 0 ? 4 : 1, step = (directions - first) / turns;
    std::vector<std::vector<int>> result;
    if(first == 1)
      result.push_back({0});
    for(int i = first; i < first + step; ++i) {
      result.emplace_back();
      for(int turn = 0; turn < turns; ++turn)
        result.back().push_back(i + turn * step);
    }
    return result;
  }

  double scale() const { return m_scale; } // if it is given
  double number_of_pages() const
  {
    return m_pages;
  } // that charts of this scale would fill; 1 for other scales

  // The texels along the sides of a square of the size of a page
  double side_of_page() const
  {
    return std::sqrt(static_cast<double>(m_options.resolution) * m_options.number_of_rows());
  }

  // Whether a page can hold the chart at the given scale, in one of its directions and in such cells
  bool fits(int c, int cell) const
  {
    const int border = 2 * ((m_options.number_of_gutter_texels() + 1) / 2);
    return std::any_of(m_angles[c].begin(), m_angles[c].end(), [&](double angle) {
      return Chart_shape(m_outlines[c], angle, scale_of(c, m_scale))
          .fits(m_options.resolution - border, m_options.number_of_rows() - border, cell);
    });
  }

  // Charts are placed by cells of this many texels along a side, first by large cells. If there are many texels, even
  // the last cells have several.
  const std::vector<int>& texels_of_cells() const { return m_cells; }

  double share(int c) const { return m_outlines[c].length * m_outlines[c].length * m_outlines[c].area; }
  bool is_turned(int c) const { return m_is_turned[c]; }
  bool is_small(int c) const { return share(c) * m_pages < largest_small_share; }
  bool is_enlarged(int c, double scale) const { return m_outlines[c].length * scale < least_extent; }

  // Of the outline, where a texel has the length 1. `scale` are the texels of the length 1.
  double scale_of(int c, double scale) const
  {
    return (std::max)(m_outlines[c].length * scale, least_extent);
  }

  // About the texels that a chart takes with its share of the gutter
  double needed_texels(int c, double scale) const
  {
    const double s = scale_of(c, scale), wide = m_options.number_of_gutter_texels() + 1;
    return m_outlines[c].area * s * s + m_outlines[c].perimeter * s * wide / 2 + wide * wide;
  }

private:
  // The most cells along a side of the page, and the least along a side of a chart
  static constexpr std::pair<double, double> finenesses[] = {{256, 12}, {512, 18}, {1024, 24}};

  // Charts with axes lie along them, except for strips and the like, which may need the diagonal.
  bool keeps_axes(int c) const
  {
    const Chart_outline& outline = m_outlines[c];
    if(!outline.has_axes)
      return false;
    const double side = outline.length * turned_extent(outline.hull, outline.angle_of_rectangle).maxCoeff();
    return side <= longest_side || share(c) >= least_share_of_square * side * side;
  }

  static constexpr double longest_side = 1.2, least_share_of_square = 0.29; // where all areas together are 1

  // That of the smallest page first, if the chart is one of few
  std::vector<double> angles(int c) const
  {
    const double full_turn = 4 * std::acos(0.);
    const int number =
        is_turned(c) ? m_options.number_of_rotations : (std::min)(4, m_options.number_of_rotations);
    std::vector<double> result;
    if(is_turned(c) && number > 1)
      result.push_back(angle_of_smallest_page(m_outlines[c].hull, aspect_ratio(m_options)));
    for(int i = 0; i < number; ++i)
      result.push_back(m_outlines[c].angle_of_rectangle + full_turn * i / number);
    return result;
  }

  const std::vector<Chart_outline>& m_outlines;
  const Packing_options& m_options;
  const double m_scale, m_pages;
  std::vector<char> m_is_turned; // of each chart
  std::vector<std::vector<double>> m_angles;
  std::vector<int> m_cells;
};

// The charts at one scale, in all directions, the largest first, and the cells of `cell`^2 texels that they touch
class Scaled_charts
{
public:
  struct Shape
  {
    Chart_shape texels;
    Texel_mask cells;
    std::vector<Row_run> runs;
  };

  // `is_allowed` tells the directions to try of each chart.
  Scaled_charts(const Charts_to_pack& charts, const std::vector<std::vector<char>>& is_allowed, double scale,
                int cell)
      : m_charts(charts), m_is_allowed(is_allowed), m_scale(scale), m_cell(cell)
  {
    sort();
    m_shapes.resize(m_order.size());
    for(int c : m_order)
      m_shapes[c].resize(charts.directions(c).size());
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
                       m_charts.scale_of(shapes.chart, m_scale));
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
      m_shapes[shapes.chart][direction].emplace(Shape{texels, *cells, longest_runs(*cells)});
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

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_SCALED_CHARTS_H
