// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The charts of a packing before they have a scale: what they need, and the directions to try.
// `scaled_charts.h` draws them at a scale, and `search_scale.h` and `fill_pages.h` pack them.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CHARTS_TO_PACK_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CHARTS_TO_PACK_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/packing/chart_outline.h>
#include <CGAL/Texture_atlas/internal/packing/chart_shape.h>
#include <CGAL/Texture_atlas/internal/packing/packing.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// All directions are tried for charts of at least this share of the area, four for others and along axes.
inline constexpr double least_turned_share = 0.02;

// Charts with less than that share of the area, and less than a texel wide, do not determine the scale of all: they are
// made smaller where they would be longer than that part of the shorter side of a page.
inline constexpr double least_unreduced_share = 0.001, longest_part_of_page = 0.02;

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

  // The scale if it is given, or 0
  double scale() const { return m_scale; }

  // That charts of the given scale would fill; 1 if none is given
  double number_of_pages() const { return m_pages; }

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
      return Chart_shape(m_outlines[c], angle, scale_of(c, m_scale), largest_border_move(m_options))
          .fits(m_options.resolution - border, m_options.number_of_rows() - border, cell);
    });
  }

  // Charts are placed by cells of this many texels along a side, first by large cells. If there are many texels, even
  // the last cells have several.
  const std::vector<int>& texels_of_cells() const { return m_cells; }

  double share(int c) const { return m_outlines[c].length * m_outlines[c].length * m_outlines[c].area; }
  bool is_turned(int c) const { return m_is_turned[c]; }
  bool is_small(int c) const { return share(c) * m_pages < largest_small_share; }
  bool is_reduced(int c, double scale) const { return m_outlines[c].length * scale > largest_scale_of(c); }
  bool is_enlarged(int c, double scale) const { return m_outlines[c].length * scale < least_extent(); }

  // Of the outline, where a texel has the length 1. `scale` are the texels of the length 1.
  double scale_of(int c, double scale) const
  {
    return (std::max)((std::min)(m_outlines[c].length * scale, largest_scale_of(c)), least_extent());
  }

  // Of a chart that is nearly a line, unless the scale is given
  double largest_scale_of(int c) const
  {
    const Chart_outline& outline = m_outlines[c];
    const double usual_scale = 0.8 * side_of_page(), mean_width = usual_scale * outline.length * outline.area;
    return m_scale > 0 || share(c) >= least_unreduced_share || mean_width >= 1
               ? HUGE_VAL
               : longest_part_of_page * (std::min)(m_options.resolution, m_options.number_of_rows());
  }

  // A chart is not made smaller than that, in texels. In four steps of a grid, few triangles lose their area.
  double least_extent() const { return (std::max)(1. / 16, 4 * texels_of_step(m_options)); }

  // About the texels that a chart takes with its share of the gutter
  double needed_texels(int c, double scale) const
  {
    const double s = scale_of(c, scale),
                 wide = m_options.number_of_gutter_texels() + 1 + 2 * largest_border_move(m_options);
    return m_outlines[c].area * s * s + m_outlines[c].perimeter * s * wide / 2 + wide * wide;
  }

  // The scale at which charts need about this share of the texels; near 0 if they always need more
  double scale_of_needed_share(double share) const
  {
    const double side = side_of_page();
    double lower = 0, upper = side;
    for(int i = 0; i < 40; ++i) {
      const double scale = (lower + upper) / 2;
      double texels = 0;
      for(int c = 0; c < number_of_charts(); ++c)
        texels += needed_texels(c, scale);
      (texels < share * side * side ? lower : upper) = scale;
    }
    return lower;
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

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CHARTS_TO_PACK_H
