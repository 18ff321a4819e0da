// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_PLANAR_CHARTS_H
#define ANGLE_BASED_FLATTENING_PLANAR_CHARTS_H

#include <CGAL/Texture_atlas/internal/packing/pack.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Charts in the plane, as triangles without connectivity, and what an atlas of them must be, looked up texel by texel
namespace test_charts {

namespace ABF = CGAL::Surface_mesh_parameterization::internal::ABF;
namespace TA = CGAL::Texture_atlas;
using ABF::Planar_point;

struct Planar_charts
{
  std::vector<Planar_point> corners;
  std::vector<int> chart;   // of each triangle
  std::vector<double> area; // the same, as it should be
  int number = 0;

  void add(const Planar_point& p, const Planar_point& q, const Planar_point& r)
  {
    corners.insert(corners.end(), {p, q, r});
    chart.push_back(number);
    area.push_back(std::abs(ABF::cross(q - p, r - p)) / 2);
  }

  void add_quadrangle(const Planar_point& p, const Planar_point& q, const Planar_point& r,
                      const Planar_point& s)
  {
    add(p, q, r);
    add(p, r, s);
  }

  void add_rectangle(double x, double y, double width, double height)
  {
    add_quadrangle({x, y}, {x + width, y}, {x + width, y + height}, {x, y + height});
  }

  // The triangles since `first_triangle` are a chart, which is turned, moved and scaled in the plane, and not in space.
  void finish_chart(std::size_t first_triangle, std::mt19937& random)
  {
    std::uniform_real_distribution<double> unit(0, 1);
    const double angle = 7 * unit(random), scale = std::exp(4 * unit(random) - 2);
    const double c = scale * std::cos(angle), s = scale * std::sin(angle);
    const Planar_point shift(100 * unit(random), -50 * unit(random));
    for(std::size_t i = 3 * first_triangle; i < corners.size(); ++i) {
      const Planar_point p = corners[i];
      corners[i] = Planar_point(c * p.x() - s * p.y(), s * p.x() + c * p.y()) + shift;
    }
    ++number;
  }
};

inline TA::internal::Packing pack(const Planar_charts& charts,
                                  const CGAL::Texture_atlas::Packing_options& options)
{
  return TA::internal::pack(charts.corners, charts.chart, charts.area, charts.number, options);
}

inline std::vector<Planar_point> placed_corners(const Planar_charts& charts,
                                                const TA::internal::Packing& packing)
{
  std::vector<Planar_point> result;
  for(std::size_t c = 0; c < charts.corners.size(); ++c)
    result.push_back(packing.placement[charts.chart[c / 3]](charts.corners[c]));
  return result;
}

inline void add_disc(Planar_charts& charts, double radius, int sides)
{
  const auto at = [&](int i) {
    const double angle = 8 * std::atan(1.) * (i % sides) / sides;
    return Planar_point(radius * std::cos(angle), radius * std::sin(angle));
  };
  for(int i = 0; i < sides; ++i)
    charts.add({0, 0}, at(i), at(i + 1));
}

inline void add_ring(Planar_charts& charts, double inner, double outer, int sides)
{
  const auto at = [&](double radius, int i) {
    const double angle = 8 * std::atan(1.) * (i % sides) / sides;
    return Planar_point(radius * std::cos(angle), radius * std::sin(angle));
  };
  for(int i = 0; i < sides; ++i)
    charts.add_quadrangle(at(inner, i), at(outer, i), at(outer, i + 1), at(inner, i + 1));
}

inline void add_L(Planar_charts& charts, double length, double width)
{
  charts.add_rectangle(0, 0, length, width);
  charts.add_rectangle(0, width, width, length - width);
}

inline void add_comb(Planar_charts& charts, int teeth, double length)
{
  charts.add_rectangle(0, 0, 2 * teeth - 1, 1);
  for(int i = 0; i < teeth; ++i)
    charts.add_rectangle(2 * i, 1, 1, length);
}

// A chart of any of these kinds. A third of all are mirrored in the plane.
inline void add_random_chart(Planar_charts& charts, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0, 1);
  const std::size_t first = charts.chart.size();
  const double size = std::exp(3 * unit(random));
  switch(random() % 6) {
  case 0:
    add_disc(charts, size, 3 + static_cast<int>(random() % 20));
    break;
  case 1:
    add_L(charts, size, size * (0.1 + 0.8 * unit(random)));
    break;
  case 2:
    add_ring(charts, size * (0.2 + 0.7 * unit(random)), size, 3 + static_cast<int>(random() % 30));
    break;
  case 3:
    add_comb(charts, 1 + static_cast<int>(random() % 5), size);
    break;
  case 4: // a needle
    charts.add({0, 0}, {size, 0}, {size * unit(random), 1e-6 * size});
    break;
  default:
    charts.add({0, 0}, {size, 0}, {size * unit(random), size * (0.1 + unit(random))});
  }
  if(random() % 3 == 0)
    for(std::size_t i = 3 * first; i < charts.corners.size(); ++i)
      charts.corners[i].x() *= -1;
  charts.finish_chart(first, random);
}

inline Planar_charts random_charts(int number, std::mt19937& random)
{
  Planar_charts charts;
  while(charts.number < number)
    add_random_chart(charts, random);
  return charts;
}

// Asks exact predicates for each texel near to a triangle whether the triangle touches it. The resolution is a power of
// two: the corners of texels are numbers of `double`.
class Texel_oracle
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

public:
  Texel_oracle(const std::vector<Planar_point>& corners, const std::vector<int>& chart, int resolution)
      : m_resolution(resolution)
  {
    for(std::size_t t = 0; t < chart.size(); ++t)
      draw({corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]}, chart[t]);
  }

  // Whether there are fewer texels between two charts than `gutter`
  bool are_too_near(int gutter) const
  {
    for(const auto& [texel, charts] : m_charts) {
      if(charts.size() > 1)
        return true;
      for(int y = texel.first - gutter; y <= texel.first + gutter; ++y)
        for(int x = texel.second - gutter; x <= texel.second + gutter; ++x)
          if(const auto other = m_charts.find({y, x}); other != m_charts.end() && other->second != charts)
            return true;
    }
    return false;
  }

  // The least number of texels between a chart and the border of the square; negative if it sticks out
  int border() const
  {
    int result = m_resolution;
    for(const auto& [texel, charts] : m_charts)
      for(int i : {texel.first, texel.second})
        result = (std::min)({result, i, m_resolution - 1 - i});
    return result;
  }

private:
  void draw(const std::array<Planar_point, 3>& corners, int chart)
  {
    Planar_point lower = corners[0], upper = corners[0];
    for(const Planar_point& p : corners) {
      lower = lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
    const auto point = [&](int k) { return Kernel::Point_2(corners[k].x(), corners[k].y()); };
    const Kernel::Triangle_2 triangle(point(0), point(1), point(2));
    const double r = m_resolution;
    for(int y = static_cast<int>(std::floor(lower.y() * r)) - 1; y <= upper.y() * r + 1; ++y)
      for(int x = static_cast<int>(std::floor(lower.x() * r)) - 1; x <= upper.x() * r + 1; ++x)
        if(touches(triangle, Kernel::Iso_rectangle_2(x / r, y / r, (x + 1) / r, (y + 1) / r))) {
          std::vector<int>& charts = m_charts[{y, x}];
          if(std::find(charts.begin(), charts.end(), chart) == charts.end())
            charts.push_back(chart);
        }
  }

  static bool touches(const Kernel::Triangle_2& triangle, const Kernel::Iso_rectangle_2& texel)
  {
    if(!triangle.is_degenerate())
      return CGAL::do_intersect(triangle, texel);
    for(int k = 0; k < 3; ++k)
      if(triangle[k] == triangle[k + 1]
             ? texel.has_on_bounded_side(triangle[k]) || texel.has_on_boundary(triangle[k])
             : CGAL::do_intersect(Kernel::Segment_2(triangle[k], triangle[k + 1]), texel))
        return true;
    return false;
  }

  int m_resolution;
  std::map<std::pair<int, int>, std::vector<int>> m_charts; // that touch each texel, by row and column
};

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_PLANAR_CHARTS_H
