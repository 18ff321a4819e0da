// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_INJECTIVITY_CHECK_H
#define ANGLE_BASED_FLATTENING_INJECTIVITY_CHECK_H

#include "overlaps.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

// What tests of injective maps measure without the library's own certificate.
namespace test_charts {

// Whether two triangles of a map have more in common than they have on the surface, or one of them is not positive
inline bool is_overlapping(const Chart& chart, const std::vector<Point_2>& uv, int s, int t)
{
  std::vector<Point_3> points;
  std::vector<int> vertices;
  Triangles triangles(2);
  for(int k = 0; k < 6; ++k) {
    const int v = chart.vertex[k < 3 ? 3 * s + k : 3 * t + k - 3];
    const auto found = std::find(vertices.begin(), vertices.end(), v);
    triangles[k / 3][k % 3] = static_cast<int>(found - vertices.begin());
    if(found == vertices.end()) {
      vertices.push_back(v);
      points.emplace_back(uv[v].x(), uv[v].y(), 0);
    }
  }
  if(s == t)
    triangles.pop_back();
  return !Overlaps(points, triangles).is_injective();
}

// All pairs are looked at, and by exact predicates unless their bounding boxes are apart. A triangle that is not
// positive is a pair with itself.
inline std::vector<std::pair<int, int>> overlapping_pairs_by_brute_force(const Chart& chart,
                                                                         const std::vector<Point_2>& uv)
{
  std::vector<CGAL::Bbox_2> boxes;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    boxes.push_back(uv[chart.vertex[3 * t]].bbox() + uv[chart.vertex[3 * t + 1]].bbox() +
                    uv[chart.vertex[3 * t + 2]].bbox());
  std::vector<std::pair<int, int>> pairs;
  for(int s = 0; s < chart.number_of_triangles(); ++s)
    for(int t = 0; t <= s; ++t)
      if(CGAL::do_overlap(boxes[s], boxes[t]) && is_overlapping(chart, uv, s, t))
        pairs.emplace_back(t, s);
  return pairs;
}

// The least distance between two border edges without a common vertex, in lengths of the longer and of the shorter one
inline std::pair<double, double> least_border_distances(const Chart& chart, const std::vector<Point_2>& uv)
{
  typedef Chart::Kernel::Segment_2 Segment;
  std::vector<int> edges;
  for(const std::vector<int>& border : chart.borders)
    edges.insert(edges.end(), border.begin(), border.end());
  std::pair<double, double> least(HUGE_VAL, HUGE_VAL);
  for(int c : edges)
    for(int d : edges) {
      const int p = chart.edge_source(c), q = chart.edge_target(c), r = chart.edge_source(d),
                s = chart.edge_target(d);
      if(c >= d || p == r || p == s || q == r || q == s)
        continue;
      const Segment first(uv[p], uv[q]), second(uv[r], uv[s]);
      const double distance = std::sqrt(CGAL::squared_distance(first, second));
      const auto [shorter, longer] =
          std::minmax({std::sqrt(first.squared_length()), std::sqrt(second.squared_length())});
      least.first = (std::min)(least.first, distance / longer);
      least.second = (std::min)(least.second, distance / shorter);
    }
  return least;
}

// The mean of |J|^2 + |J^-1|^2 over the surface, for the differential J of the map, scaled so that areas are equal; 4
// at best.
inline double symmetric_dirichlet_energy(const Chart& chart, const std::vector<Point_2>& uv)
{
  double all_surface = 0, all_plane = 0, stretching = 0, shrinking = 0;
  for(int t = 0; t < chart.number_of_triangles(); ++t) {
    const int a = chart.vertex[3 * t], b = chart.vertex[3 * t + 1], c = chart.vertex[3 * t + 2];
    const auto p = chart.points[b] - chart.points[a], q = chart.points[c] - chart.points[a];
    const auto u = uv[b] - uv[a], w = uv[c] - uv[a];
    const double surface = (p * p) * (q * q) - (p * q) * (p * q), plane = CGAL::determinant(u, w);
    const double square = ((q * q) * (u * u) - 2 * (p * q) * (u * w) + (p * p) * (w * w)) / surface;
    const double area = std::sqrt(surface);
    all_surface += area;
    all_plane += plane;
    stretching += area * square;
    shrinking += area * square * surface / (plane * plane);
  }
  const double scale = all_surface / all_plane;
  return (stretching * scale + shrinking / scale) / all_surface;
}

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_INJECTIVITY_CHECK_H
