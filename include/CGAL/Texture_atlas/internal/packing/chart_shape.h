// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A chart at one angle and scale, drawn as a mask of the cells that it touches.
// `scaled_charts.h` makes these shapes for all charts and directions that the search tries.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CHART_SHAPE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CHART_SHAPE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/packing/chart_outline.h>
#include <CGAL/Texture_atlas/internal/packing/texel_mask.h>
#include <CGAL/Texture_atlas/internal/packing/visit_texels.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Coordinates may move by that many texels when they are rounded, and keep the place that was found for them: enough
// for floats.
inline constexpr double placement_tolerance = 1. / (1 << 8);

// A chart turned and scaled. Its coordinates are those of the outline times a complex number, plus `shift`.
class Chart_shape
{
public:
  // `scale` is the length of 1 in the outline, in texels. Borders may move by `slack` texels in both directions later.
  Chart_shape(const Chart_outline& outline, double angle, double scale, double slack)
      : m_outline(&outline), m_cosine(scale * std::cos(angle)), m_sine(scale * std::sin(angle)),
        m_slack(slack)
  {
    Planar_point lower(HUGE_VAL, HUGE_VAL), upper = -lower;
    for(const Planar_point& p : outline.hull) {
      const Planar_point q = turned(p);
      lower = lower.cwiseMin(q);
      upper = upper.cwiseMax(q);
    }
    m_width = texels_of(upper.x() - lower.x() + 2 * slack);
    m_height = texels_of(upper.y() - lower.y() + 2 * slack);
    m_shift = (Planar_point(m_width, m_height) - lower - upper) / 2;
  }

  double cosine() const { return m_cosine; }
  double sine() const { return m_sine; }
  const Planar_point& shift() const { return m_shift; }

  // Whether a page of that many texels holds it, in cells of `side`^2 texels
  bool fits(int width, int height, int side = 1) const
  {
    return cells_along(m_width, side) <= width / side && cells_along(m_height, side) <= height / side;
  }

  // Turned counterclockwise by a right angle: where whole cells of `side`^2 texels hold it, they turn with it.
  Chart_shape quarter_turn(int side) const
  {
    Chart_shape result = *this;
    result.m_cosine = -m_sine;
    result.m_sine = m_cosine;
    result.m_width = m_height;
    result.m_height = m_width;
    result.m_shift = {side * cells_along(m_height, side) - m_shift.y(), m_shift.x()};
    return result;
  }

  // The cells of `side`^2 texels that the chart touches, or comes nearer to than `gutter` texels, in a mask that is
  // larger by `margin` cells on all sides
  Texel_mask cells(int side, int gutter = 0, int margin = 0) const
  {
    Texel_mask mask(cells_along(m_width, side) + 2 * margin, cells_along(m_height, side) + 2 * margin);
    std::vector<Crossing> crossings;
    const auto cell = [&](const Planar_point& p) -> Planar_point {
      return (turned(p) + m_shift) / side + Planar_point(margin, margin);
    };
    const double tolerance = placement_tolerance / side, neighbours = (gutter + m_slack) / side;
    for(const Planar_segment& edge : m_outline->edges) {
      const Planar_point p = cell(edge[0]), q = cell(edge[1]);
      draw_segment(p, q, tolerance, neighbours, mask);
      cross_rows(p, q, crossings);
    }
    for(const Planar_segment& needle : m_outline->needles)
      draw_segment(cell(needle[0]), cell(needle[1]), tolerance, neighbours, mask);
    fill(crossings, mask);
    return mask;
  }

private:
  struct Crossing
  {
    int y;
    double x;
    int turn;
  };

  static constexpr int too_many_texels = 1 << 30;

  static int cells_along(int texels, int side) { return (texels + side - 1) / side; }

  static int texels_of(double length)
  {
    return static_cast<int>(
        std::clamp(std::ceil(length + 8 * placement_tolerance), 1., 1. * too_many_texels));
  }

  Planar_point turned(const Planar_point& p) const
  {
    return {m_cosine * p.x() - m_sine * p.y(), m_sine * p.x() + m_cosine * p.y()};
  }

  static void draw_segment(const Planar_point& p, const Planar_point& q, double tolerance, double neighbours,
                           Texel_mask& mask)
  {
    const double reach = neighbours + 2 * tolerance;
    const int x = floor_of((std::min)(p.x(), q.x()) - reach), y = floor_of((std::min)(p.y(), q.y()) - reach);
    if(x == floor_of((std::max)(p.x(), q.x()) + reach) && y == floor_of((std::max)(p.y(), q.y()) + reach)) {
      mask.add(x, x + 1, y);
      return;
    }
    visit_texels(
        p, q, tolerance, [&](int y, int first, int last) { mask.add(first, last + 1, y); }, neighbours);
  }

  static void cross_rows(const Planar_point& p, const Planar_point& q, std::vector<Crossing>& crossings)
  {
    const int turn = p.y() > q.y() ? 1 : -1;
    const Planar_point &lower = turn > 0 ? q : p, &upper = turn > 0 ? p : q;
    for(int y = -floor_of(0.5 - lower.y()); y + 0.5 < upper.y(); ++y)
      crossings.push_back(
          {y, lower.x() + (y + 0.5 - lower.y()) / (upper.y() - lower.y()) * (upper.x() - lower.x()), turn});
  }

  // A cell that no edge touches is inside if its centre is. Crossings are sorted by rows first: most rows have few.
  static void fill(const std::vector<Crossing>& crossings, Texel_mask& mask)
  {
    std::vector<int> end(mask.height() + 1, 0);
    for(const Crossing& crossing : crossings)
      ++end[crossing.y + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Crossing> sorted(crossings.size());
    for(const Crossing& crossing : crossings)
      sorted[end[crossing.y]++] = crossing;
    auto begin = sorted.begin();
    for(int y = 0; y < mask.height(); ++y) {
      const auto stop = sorted.begin() + end[y];
      std::sort(begin, stop, [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
      int winding = 0;
      for(; begin != stop; ++begin) {
        winding += begin->turn;
        if(winding != 0)
          mask.add(-floor_of(0.5 - begin->x), -floor_of(0.5 - (begin + 1)->x), y);
      }
    }
  }

  const Chart_outline* m_outline;
  double m_cosine, m_sine, m_slack;
  int m_width = 0, m_height = 0; // in texels
  Planar_point m_shift = Planar_point::Zero();
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PACKING_CHART_SHAPE_H
