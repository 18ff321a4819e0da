// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_CHARTS_WITH_HOLES_H
#define ANGLE_BASED_FLATTENING_CHARTS_WITH_HOLES_H

#include "hard_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

// Charts with several borders. All random numbers come from `random`.
namespace test_charts {

inline Triangles triangles_of(const Chart& chart)
{
  Triangles triangles;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    triangles.push_back({chart.vertex[3 * t], chart.vertex[3 * t + 1], chart.vertex[3 * t + 2]});
  return triangles;
}

// The chart of some triangles, without points that none of them has. The border with most edges becomes the outer one.
inline Chart part_of_chart(const Chart& chart, const std::vector<char>& is_removed)
{
  std::vector<int> rank(chart.points.size(), -1);
  std::vector<Point_3> points;
  Triangles triangles;
  for(std::array<int, 3> triangle : triangles_of(chart)) {
    if(is_removed[triangle[0]] || is_removed[triangle[1]] || is_removed[triangle[2]])
      continue;
    for(int& v : triangle) {
      if(rank[v] < 0) {
        rank[v] = static_cast<int>(points.size());
        points.push_back(chart.points[v]);
      }
      v = rank[v];
    }
    triangles.push_back(triangle);
  }
  Chart part = make_chart(points, triangles);
  const auto longest = std::max_element(part.borders.begin(), part.borders.end(),
                                        [](const auto& a, const auto& b) { return a.size() < b.size(); });
  abf::find_borders(part, longest->front());
  return part;
}

// All vertices within a number of rings around `center`
inline std::vector<int> vertices_around(const Chart& chart, int center, int rings)
{
  const Triangles triangles = triangles_of(chart);
  std::vector<char> is_found(chart.points.size(), false);
  std::vector<int> found{center};
  is_found[center] = true;
  for(int ring = 0; ring < rings; ++ring) {
    const std::vector<char> before = is_found;
    for(const auto& triangle : triangles)
      if(before[triangle[0]] || before[triangle[1]] || before[triangle[2]])
        for(int v : triangle)
          if(!is_found[v]) {
            is_found[v] = true;
            found.push_back(v);
          }
  }
  return found;
}

// Removes the vertices within `rings` rings of random ones, up to `holes` times, where that makes a hole apart from the
// border and from all others.
inline Chart punched(const Chart& chart, int holes, int rings, std::mt19937& random)
{
  std::vector<char> is_removed(chart.points.size(), false);
  for(int tries = 0, made = 0; made < holes && tries < 20 * holes; ++tries) {
    const int center = uniform_int(random, 0, chart.number_of_vertices() - 1);
    const std::vector<int> around = vertices_around(chart, center, rings + 2);
    if(std::any_of(around.begin(), around.end(),
                   [&](int v) { return is_removed[v] || chart.interior[v] < 0; }))
      continue;
    std::vector<char> with_this = is_removed;
    for(int v : vertices_around(chart, center, rings))
      with_this[v] = true;
    if(static_cast<int>(part_of_chart(chart, with_this).borders.size()) != made + 2)
      continue; // it would fall apart, or touch itself
    is_removed = with_this;
    ++made;
  }
  return part_of_chart(chart, is_removed);
}

// A surface of revolution whose radius changes from `inner` to `outer` over `height`: a ring without height, or a tube.
// Its outer border is the second one's.
inline Chart tube(int columns, int rows, double inner, double outer, double height)
{
  std::vector<Point_3> points;
  Triangles triangles;
  for(int j = 0; j <= rows; ++j)
    for(int i = 0; i < columns; ++i) {
      const double angle = 2 * CGAL_PI * (i + 0.5 * j) / columns, radius = inner + (outer - inner) * j / rows;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), height * j / rows);
      if(j == rows)
        continue;
      const int a = j * columns + i, b = j * columns + (i + 1) % columns, c = a + columns, d = b + columns;
      triangles.push_back({a, c, b});
      triangles.push_back({b, c, d});
    }
  Chart chart = make_chart(points, triangles);
  for(const std::vector<int>& border : chart.borders)
    if(chart.edge_source(border.front()) >= columns * rows) {
      abf::find_borders(chart, border.front());
      break;
    }
  return chart;
}

// A sphere without the vertices within some rings of random ones, at least two of them.
inline Chart sphere_without_caps(int subdivisions, int caps, int rings, std::mt19937& random)
{
  const auto [points, triangles] = sphere(subdivisions);
  const Chart closed = make_chart(points, triangles);
  std::vector<char> is_removed(points.size(), false);
  for(int v : vertices_around(closed, 0, rings))
    is_removed[v] = true;
  return punched(part_of_chart(closed, is_removed), caps - 1, rings, random);
}

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_CHARTS_WITH_HOLES_H
