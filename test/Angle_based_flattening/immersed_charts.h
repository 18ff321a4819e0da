// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_IMMERSED_CHARTS_H
#define ANGLE_BASED_FLATTENING_IMMERSED_CHARTS_H

#include "overlaps.h"

#include <algorithm>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Surfaces over the plane that cover it more or less than once. Their points are few, so that all kinds of contact are
// common, and their height is 0.
namespace test_charts {

// Positively oriented triangles, put one by one onto the border of others: what comes of it has holes, handles, pinched
// vertices and several components. The first ones do not overlap.
class Random_surface
{
public:
  Random_surface(int places, int careful, int careless, std::mt19937& random)
      : m_random(random), m_places(places)
  {
    for(int i = 0; i < careful; ++i)
      add_triangle(true);
    for(int i = 0; i < careless; ++i)
      add_triangle(false);
  }

  const std::vector<Point_3>& points() const { return m_points; }
  const Triangles& triangles() const { return m_triangles; }

private:
  int draw(int n) { return static_cast<int>(m_random() % static_cast<unsigned>(n)); }

  Point_3 random_place()
  {
    const int x = draw(m_places), y = draw(m_places);
    return Point_3(x, y, 0);
  }

  int random_vertex()
  {
    if(m_points.empty() || draw(3) == 0)
      m_points.push_back(random_place());
    else if(draw(2) == 0)
      return draw(static_cast<int>(m_points.size()));
    return static_cast<int>(m_points.size()) - 1;
  }

  // Vertices that no triangle uses are taken away again.
  void add_triangle(bool careful)
  {
    const std::size_t before = m_points.size();
    for(int attempt = 0; attempt < 200; ++attempt) {
      m_points.resize(before);
      if(m_triangles.empty() || draw(10) == 0) {
        for(int k = 0; k < 3; ++k)
          m_points.push_back(random_place());
        const int v = static_cast<int>(before);
        if(accept({v, v + 1, v + 2}, careful))
          return;
        continue;
      }
      const auto& t = m_triangles[draw(static_cast<int>(m_triangles.size()))];
      const int k = draw(3), v = random_vertex();
      if(accept({t[(k + 1) % 3], t[k], v}, careful))
        return;
    }
    m_points.resize(before);
  }

  bool accept(const std::array<int, 3>& t, bool careful)
  {
    if(t[0] == t[2] || t[1] == t[2])
      return false;
    for(int k = 0; k < 3; ++k)
      if(m_edges.count({t[k], t[(k + 1) % 3]}) > 0)
        return false;
    m_triangles.push_back(t);
    const Overlaps overlaps(m_points, careful ? m_triangles : Triangles{t});
    if(!overlaps.is_injective()) {
      m_triangles.pop_back();
      return false;
    }
    for(int k = 0; k < 3; ++k)
      m_edges.insert({t[k], t[(k + 1) % 3]});
    return true;
  }

  std::mt19937& m_random;
  int m_places;
  std::vector<Point_3> m_points;
  Triangles m_triangles;
  std::set<std::pair<int, int>> m_edges;
};

// A disk that grows over the plane, triangle by triangle: outward from a border edge, or between two of them. All
// triangles are positively oriented, but they may overlap, touch, and go around a vertex more than once.
class Random_disk
{
public:
  Random_disk(int triangles, int places, std::mt19937& random) : m_random(random), m_places(places)
  {
    while(m_triangles.empty())
      start();
    for(int attempt = 0; attempt < 50 * triangles && static_cast<int>(m_triangles.size()) < triangles;
        ++attempt)
      grow();
  }

  const std::vector<Point_3>& points() const { return m_points; }
  const Triangles& triangles() const { return m_triangles; }

private:
  int draw(int n) { return static_cast<int>(m_random() % static_cast<unsigned>(n)); }

  Point_3 random_place()
  {
    const int x = draw(m_places), y = draw(m_places);
    return Point_3(x, y, 0);
  }

  void start()
  {
    m_points = {random_place(), random_place(), random_place()};
    if(Overlaps(m_points, {{0, 1, 2}}).are_positive()) {
      m_triangles = {{0, 1, 2}};
      m_border = {0, 1, 2};
      m_edges = {{0, 1}, {1, 2}, {0, 2}};
    }
  }

  void grow()
  {
    const int size = static_cast<int>(m_border.size()), i = draw(size), j = (i + 1) % size,
              k = (i + 2) % size;
    const bool is_between = draw(2) == 0;
    const int u = m_border[i], v = m_border[j];
    int w = m_border[k];
    if(!is_between) {
      w = static_cast<int>(m_points.size());
      m_points.push_back(random_place());
    }
    if((is_between && m_edges.count(std::minmax({u, w})) > 0) ||
       !Overlaps(m_points, {{v, u, w}}).are_positive()) {
      m_points.resize(m_points.size() - (is_between ? 0 : 1));
      return;
    }
    m_triangles.push_back({v, u, w});
    m_edges.insert({std::minmax({u, w}), std::minmax({v, w})});
    if(is_between)
      m_border.erase(m_border.begin() + j);
    else
      m_border.insert(m_border.begin() + j, w);
  }

  std::mt19937& m_random;
  int m_places;
  std::vector<Point_3> m_points;
  Triangles m_triangles;
  std::vector<int> m_border; // its vertices, with the disk on the left
  std::set<std::pair<int, int>> m_edges;
};

// Two sheets, the smaller one over the larger one, cut from (-1, 0) to (1, 0) and glued crosswise: a ring whose borders
// are simple, do not touch, and both turn left. At each end of the cut triangles go around twice or, if the border of
// the smaller sheet runs through it, more than once.
class Crosswise_sheets
{
public:
  Crosswise_sheets(bool left_end_on_border, bool right_end_on_border)
  {
    enum
    {
      LEFT,
      RIGHT,
      MIDDLE_1,
      MIDDLE_2,
      FIRST
    };
    m_points = {{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    for(int sheet : {1, 2}) {
      const int west = FIRST + 4 * (sheet - 1), south = west + 1, east = west + 2, north = west + 3;
      const double size = sheet == 1 ? 2 : 1;
      for(const auto& [x, y] : {std::pair(-2, 0), std::pair(0, -1), std::pair(2, 0), std::pair(0, 1)})
        m_points.emplace_back(size * x, size * y, 0);
      const int above = sheet == 1 ? MIDDLE_1 : MIDDLE_2, below = sheet == 1 ? MIDDLE_2 : MIDDLE_1;
      m_triangles.insert(
          m_triangles.end(),
          {{LEFT, above, north}, {above, RIGHT, north}, {below, LEFT, south}, {RIGHT, below, south}});
      if(sheet == 1 || !left_end_on_border)
        m_triangles.insert(m_triangles.end(), {{west, LEFT, north}, {west, south, LEFT}});
      if(sheet == 1 || !right_end_on_border)
        m_triangles.insert(m_triangles.end(), {{RIGHT, east, north}, {RIGHT, south, east}});
    }
  }

  const std::vector<Point_3>& points() const { return m_points; }
  const Triangles& triangles() const { return m_triangles; }

private:
  std::vector<Point_3> m_points;
  Triangles m_triangles;
};

// A grid over the plane with random holes, some of which are moved.
class Punched_grid
{
public:
  Punched_grid(int n, int moves, std::mt19937& random)
  {
    std::vector<Point_3> all;
    for(int i = 0; i <= n; ++i)
      for(int j = 0; j <= n; ++j) {
        const int x = 8 * i + random() % 4, y = 8 * j + random() % 4;
        all.emplace_back(x, y, 0);
      }
    std::vector<int> vertex(all.size(), -1);
    auto add = [&](int u, int v, int w) {
      if(random() % 4 == 0)
        return;
      for(int x : {u, v, w})
        if(vertex[x] < 0) {
          vertex[x] = static_cast<int>(m_points.size());
          m_points.push_back(all[x]);
        }
      m_triangles.push_back({vertex[u], vertex[v], vertex[w]});
    };
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j) {
        const int a = i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
        add(a, b, d);
        add(b, c, d);
      }
    const std::vector<std::vector<int>> borders = make_chart(m_points, m_triangles).borders;
    for(int move = 0; move < moves && !borders.empty(); ++move)
      move_vertices(borders[random() % borders.size()], random);
  }

  const std::vector<Point_3>& points() const { return m_points; }
  const Triangles& triangles() const { return m_triangles; }

private:
  // Those around a border are shifted together, turned inside out, or moved one by one.
  void move_vertices(const std::vector<int>& corners, std::mt19937& random)
  {
    std::set<int> vertices;
    for(int c : corners)
      vertices.insert(m_triangles[c / 3][(c + 1) % 3]);
    auto step = [&] { return static_cast<int>(random() % 15) - 7; };
    const int kind = random() % 3, center = static_cast<int>(m_points[*vertices.begin()].x());
    int x = step(), y = step();
    for(int v : vertices) {
      const Point_3& p = m_points[v];
      m_points[v] = Point_3(kind == 0 ? 2 * center - p.x() : p.x() + x, p.y() + y, 0);
      if(kind == 1) {
        x = step();
        y = step();
      }
    }
  }

  std::vector<Point_3> m_points;
  Triangles m_triangles;
};

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_IMMERSED_CHARTS_H
