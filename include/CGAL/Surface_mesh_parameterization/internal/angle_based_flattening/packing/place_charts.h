// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PLACE_CHARTS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PLACE_CHARTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/chart_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/occupied_cells.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/pack.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A chart is not made smaller than that, in texels.
inline constexpr double least_extent = 1. / 16;

// All directions are tried for charts of at least this share of the area, the four of the smallest rectangle for others.
inline constexpr double least_turned_share = 0.02;

// Of smaller charts, the first row where the last one found a place is where the next one begins to look, until charts are smaller by
// `alike`.
inline constexpr double largest_small_share = 0.002, alike = 0.75;

struct Chart_place
{
  double cosine = 1, sine = 0;               // times the scale, in texels
  Planar_point shift = Planar_point::Zero(); // in texels
};

// Places charts of one scale, the largest first, each where its upper end is lowest.
class Chart_placer
{
public:
  Chart_placer(const std::vector<Chart_outline>& outlines, const Packing_options& options)
      : m_outlines(outlines), m_options(options), m_border((options.gutter + 1) / 2),
        m_cell((options.resolution + most_cells - 1) / most_cells),
        m_margin((options.gutter + m_cell - 1) / m_cell)
  {}

  // `scale` is how many texels have the length 1.
  std::optional<std::vector<Chart_place>> place(double scale) const
  {
    Occupied_cells occupied((m_options.resolution - 2 * m_border) / m_cell, m_margin);
    std::vector<Chart_place> places(m_outlines.size());
    Row_hint hint;
    bool is_first = true;
    for(int c : largest_first(scale)) {
      if(!place(c, scale, is_first, occupied, hint, places[c]))
        return std::nullopt;
      is_first = false;
    }
    return places;
  }

  double share(int c) const { return m_outlines[c].length * m_outlines[c].length * m_outlines[c].area; }
  bool is_turned(int c) const { return share(c) >= least_turned_share; }
  bool is_small(int c) const { return share(c) < largest_small_share; }
  bool is_enlarged(int c, double scale) const { return m_outlines[c].length * scale < least_extent; }
  double scale_of(int c, double scale) const
  {
    return (std::max)(m_outlines[c].length * scale, least_extent);
  }

  // About the texels that a chart takes with its share of the gutter
  double needed_texels(int c, double scale) const
  {
    const double s = scale_of(c, scale), wide = m_options.gutter + 1;
    return m_outlines[c].area * s * s + m_outlines[c].perimeter * s * wide / 2 + wide * wide;
  }

private:
  static constexpr int most_cells = 2048; // of a row: where there are more texels, several are one

  struct Row_hint
  {
    double texels = 0; // of the chart that began at row 0
    int row = 0;
  };

  struct Candidate
  {
    std::optional<Chart_shape> shape;
    std::optional<Texel> place;
    int top = 0;
  };

  std::vector<int> largest_first(double scale) const
  {
    std::vector<double> texels(m_outlines.size());
    for(std::size_t c = 0; c < texels.size(); ++c)
      texels[c] = needed_texels(static_cast<int>(c), scale);
    std::vector<int> order(texels.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return texels[a] > texels[b]; });
    return order;
  }

  std::vector<double> angles(int c, bool is_first) const
  {
    const double full_turn = 4 * std::acos(0.), first = is_first
                                                            ? angle_of_smallest_square(m_outlines[c].hull)
                                                            : m_outlines[c].angle_of_rectangle;
    const int number =
        is_turned(c) ? m_options.number_of_rotations : (std::min)(4, m_options.number_of_rotations);
    std::vector<double> result;
    for(int i = 0; i < number; ++i)
      result.push_back(first + full_turn * i / number);
    return result;
  }

  // Candidates that cannot be the best are given up: how many are, depends on their order in time, the best one does not.
  bool place(int c, double scale, bool is_first, Occupied_cells& occupied, Row_hint& hint,
             Chart_place& result) const
  {
    const double texels = needed_texels(c, scale);
    if(!is_small(c) || texels < alike * hint.texels)
      hint = {texels, 0};
    const std::vector<double> directions = angles(c, is_first);
    std::vector<Candidate> candidates(directions.size());
    std::atomic<int> lowest_top(occupied.side());
    const auto find = [&](int i) {
      candidates[i] = candidate(c, directions[i], scale, occupied, hint.row, lowest_top);
    };
    if(is_turned(c))
      parallel_for(static_cast<int>(directions.size()), find);
    else
      for(std::size_t i = 0; i < directions.size(); ++i)
        find(static_cast<int>(i));
    const Candidate* best = nullptr;
    for(const Candidate& candidate : candidates)
      if(candidate.place && (best == nullptr || is_better(candidate, *best)))
        best = &candidate;
    if(best == nullptr)
      return false;
    hint.row = best->place->y;
    occupy(*best, occupied);
    const Planar_point corner(m_border + m_cell * best->place->x, m_border + m_cell * best->place->y);
    result = {best->shape->cosine(), best->shape->sine(), best->shape->shift() + corner};
    return true;
  }

  Candidate candidate(int c, double angle, double scale, const Occupied_cells& occupied, int first_row,
                      std::atomic<int>& lowest_top) const
  {
    Candidate result;
    result.shape.emplace(m_outlines[c], angle, scale_of(c, scale));
    const Texel_mask cells = cells_of(result.shape->mask(), 0, 0, m_cell);
    result.place = occupied.find_place(cells, first_row, [&](int y) {
      return y + cells.height() > lowest_top.load(std::memory_order_relaxed);
    });
    if(result.place) {
      result.top = result.place->y + cells.height();
      for(int top = lowest_top; result.top < top && !lowest_top.compare_exchange_weak(top, result.top);)
        continue;
    }
    return result;
  }

  static bool is_better(const Candidate& a, const Candidate& b)
  {
    return a.top < b.top || (a.top == b.top && a.place->x < b.place->x);
  }

  // With the gutter
  void occupy(const Candidate& candidate, Occupied_cells& occupied) const
  {
    const Texel_mask wide = dilated(candidate.shape->mask(), m_options.gutter);
    const int offset = m_margin * m_cell - m_options.gutter;
    occupied.add(cells_of(wide, offset, offset, m_cell), candidate.place->x, candidate.place->y);
  }

  const std::vector<Chart_outline>& m_outlines;
  const Packing_options& m_options;
  const int m_border; // texels between the border of the square and charts
  const int m_cell;   // texels along the side of a cell
  const int m_margin; // cells that the gutter may stick out
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_PLACE_CHARTS_H
