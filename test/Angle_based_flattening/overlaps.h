// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_OVERLAPS_H
#define ANGLE_BASED_FLATTENING_OVERLAPS_H

#include "test_charts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <vector>

// Whether a map is injective, pair by pair of its triangles: slow, exact, and without a theorem.
namespace test_charts {

// The triangles of a chart, seen along the z-axis.
class Overlaps
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef std::array<int, 3> Triangle;

public:
  explicit Overlaps(const std::vector<Point_3>& points, const Triangles& triangles)
  {
    for(const Point_3& p : points)
      m_points.emplace_back(p.x(), p.y());
    for(const Triangle& t : triangles)
      m_are_positive = m_are_positive && turn(t[0], t[1], t[2]) == CGAL::LEFT_TURN;
    for(auto s = triangles.begin(); s != triangles.end() && m_are_positive; ++s)
      for(auto t = triangles.begin(); t != s; ++t) {
        const std::vector<int> common = common_vertices(*s, *t);
        if(common.empty() ? meet(*s, *t) : meet_beyond(common, *s, *t))
          (common.empty() ? m_apart : m_at_vertices) = true;
      }
  }

  bool are_positive() const { return m_are_positive; }
  bool is_locally_injective() const { return m_are_positive && !m_at_vertices; }
  bool is_injective() const { return is_locally_injective() && !m_apart; }

private:
  CGAL::Orientation turn(int u, int v, int w) const
  {
    return CGAL::orientation(m_points[u], m_points[v], m_points[w]);
  }

  static std::vector<int> common_vertices(const Triangle& s, const Triangle& t)
  {
    std::vector<int> common;
    for(int v : s)
      if(std::find(t.begin(), t.end(), v) != t.end())
        common.push_back(v);
    return common;
  }

  bool meet(const Triangle& s, const Triangle& t) const
  {
    return CGAL::do_intersect(Kernel::Triangle_2(m_points[s[0]], m_points[s[1]], m_points[s[2]]),
                              Kernel::Triangle_2(m_points[t[0]], m_points[t[1]], m_points[t[2]]));
  }

  // The third vertices are on both sides of a common edge; the sectors at a common vertex are apart.
  bool meet_beyond(const std::vector<int>& common, const Triangle& s, const Triangle& t) const
  {
    if(common.size() == 2)
      return turn(common[0], common[1], other(common, s)) == turn(common[0], common[1], other(common, t));
    return common.size() == 3 || has_ray_in(common[0], s, t) || has_ray_in(common[0], t, s);
  }

  static int other(const std::vector<int>& common, const Triangle& t)
  {
    return *std::find_if(t.begin(), t.end(), [&](int v) { return v != common[0] && v != common[1]; });
  }

  // Whether a triangle lies, from one of its vertices on, in the sector of another one there.
  bool has_ray_in(int v, Triangle s, Triangle t) const
  {
    std::rotate(s.begin(), std::find(s.begin(), s.end(), v), s.end());
    std::rotate(t.begin(), std::find(t.begin(), t.end(), v), t.end());
    auto is_in_sector = [&](int w) {
      return turn(v, t[1], w) != CGAL::RIGHT_TURN && turn(v, w, t[2]) != CGAL::RIGHT_TURN;
    };
    return is_in_sector(s[1]) || is_in_sector(s[2]);
  }

  std::vector<Kernel::Point_2> m_points;
  bool m_are_positive = true, m_at_vertices = false, m_apart = false;
};

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_OVERLAPS_H
