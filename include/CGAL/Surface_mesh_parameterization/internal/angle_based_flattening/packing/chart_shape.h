// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_CHART_SHAPE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_CHART_SHAPE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/chart_outline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/texel_mask.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/packing/visit_texels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Coordinates may move by that many texels when they are rounded, and keep the place that was found for them: enough for floats.
inline constexpr double placement_tolerance = 1. / (1 << 8);

// A chart turned and scaled, as texels. Its coordinates are those of the outline times a complex number, plus `shift`.
class Chart_shape
{
public:
  // `scale` is the length of 1 in the outline, in texels.
  Chart_shape(const Chart_outline& outline, double angle, double scale)
      : m_cosine(scale * std::cos(angle)), m_sine(scale * std::sin(angle)), m_mask(0, 0)
  {
    Planar_point lower(HUGE_VAL, HUGE_VAL), upper = -lower;
    for(const Planar_point& p : outline.hull) {
      const Planar_point q = turned(p);
      lower = lower.cwiseMin(q);
      upper = upper.cwiseMax(q);
    }
    const Planar_point extent = upper - lower;
    const int width = texels_of(extent.x()), height = texels_of(extent.y());
    m_shift = (Planar_point(width, height) - lower - upper) / 2;
    m_mask = Texel_mask(width, height);
    draw(outline);
  }

  double cosine() const { return m_cosine; }
  double sine() const { return m_sine; }
  const Planar_point& shift() const { return m_shift; }
  const Texel_mask& mask() const { return m_mask; }

private:
  struct Crossing
  {
    int y;
    double x;
    int turn;

    bool operator<(const Crossing& other) const { return y < other.y || (y == other.y && x < other.x); }
  };

  static int texels_of(double length)
  {
    return (std::max)(1, static_cast<int>(std::ceil(length + 8 * placement_tolerance)));
  }

  Planar_point turned(const Planar_point& p) const
  {
    return {m_cosine * p.x() - m_sine * p.y(), m_sine * p.x() + m_cosine * p.y()};
  }

  // A texel that no edge touches is inside if its centre is.
  void draw(const Chart_outline& outline)
  {
    std::vector<Crossing> crossings;
    const auto draw_segment = [&](const Planar_point& p, const Planar_point& q) {
      visit_texels(std::array<Planar_point, 2>{p, q}, placement_tolerance,
                   [&](int y, int first, int last) { m_mask.add(first, last + 1, y); });
    };
    for(const Planar_segment& edge : outline.edges) {
      const Planar_point p = turned(edge[0]) + m_shift, q = turned(edge[1]) + m_shift;
      draw_segment(p, q);
      cross_rows(p, q, crossings);
    }
    for(const Planar_segment& needle : outline.needles)
      draw_segment(turned(needle[0]) + m_shift, turned(needle[1]) + m_shift);
    fill(crossings);
  }

  static void cross_rows(const Planar_point& p, const Planar_point& q, std::vector<Crossing>& crossings)
  {
    const int turn = p.y() > q.y() ? 1 : -1;
    const Planar_point &lower = turn > 0 ? q : p, &upper = turn > 0 ? p : q;
    for(int y = static_cast<int>(std::ceil(lower.y() - 0.5)); y + 0.5 < upper.y(); ++y)
      crossings.push_back(
          {y, lower.x() + (y + 0.5 - lower.y()) / (upper.y() - lower.y()) * (upper.x() - lower.x()), turn});
  }

  void fill(std::vector<Crossing>& crossings)
  {
    std::sort(crossings.begin(), crossings.end());
    int winding = 0;
    for(std::size_t i = 0; i + 1 < crossings.size(); ++i) {
      winding += crossings[i].turn;
      if(winding != 0)
        m_mask.add(static_cast<int>(std::ceil(crossings[i].x - 0.5)),
                   static_cast<int>(std::ceil(crossings[i + 1].x - 0.5)), crossings[i].y);
    }
  }

  double m_cosine, m_sine;
  Planar_point m_shift;
  Texel_mask m_mask;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_PACKING_CHART_SHAPE_H
