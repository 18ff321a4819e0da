// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Polygons of all kinds, and a quadrangle mesh like those that artists begin with.

#ifndef TEST_RANDOM_POLYGONS_H
#define TEST_RANDOM_POLYGONS_H

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace random_polygons {

using Point = std::array<double, 3>;

enum class Kind
{
  PLANAR,   // crosses itself
  LATTICE,  // with many straight runs and equal points
  GAUSSIAN, // is not planar
  STAR      // is planar, and does not cross itself
};

// Numbers of standard libraries differ, and these do not.
class Random
{
public:
  explicit Random(const unsigned seed) : m_engine(seed) {}

  int below(const int n) { return static_cast<int>(m_engine() % static_cast<unsigned>(n)); }
  double unit() { return m_engine() / 4294967296.; }

  double gaussian()
  {
    double sum = -6;
    for(int i = 0; i < 12; ++i)
      sum += unit();
    return sum;
  }

private:
  std::mt19937 m_engine;
};

inline Point random_point(const Kind kind, const double turn, Random& random)
{
  switch(kind) {
  case Kind::PLANAR: {
    const double x = random.unit(), y = random.unit();
    return {x, y, 3 * x - 2 * y};
  }
  case Kind::LATTICE:
    return {140. + random.below(4), double(random.below(4)), double(random.below(2))};
  case Kind::GAUSSIAN:
    return {random.gaussian(), random.gaussian(), random.gaussian()};
  case Kind::STAR:
    break;
  }
  const double radius = 0.2 + random.unit();
  return {radius * std::cos(turn), radius * std::sin(turn), 5};
}

// From 3 to 40 corners. Unless they are stars, some points come again, and some lie between two others.
inline std::vector<Point> polygon(const Kind kind, Random& random)
{
  const int size = 3 + random.below(38);
  std::vector<Point> points;
  for(int i = 0; i < size; ++i) {
    points.push_back(random_point(kind, 6.28 * i / size, random));
    const auto other = [&]() { return points[static_cast<std::size_t>(random.below(i))]; };
    if(kind != Kind::STAR && i > 1 && random.below(6) == 0) {
      const Point p = other(), q = random.below(2) == 0 ? p : points[points.size() - 2];
      points.back() = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2};
    }
  }
  return points;
}

// The surface of an animal of cubes, whose vertices are moved: quadrangles that are not planar, and on its back a
// polygon around a corner
class Animal
{
public:
  explicit Animal(const unsigned seed, const double noise) : m_random(seed), m_noise(noise)
  {
    add_box({0, 0, 2}, {5, 3, 4});
    for(const int x : {0, 4})
      for(const int y : {0, 2})
        add_box({x, y, 0}, {x + 1, y + 1, 2});
    add_box({5, 1, 3}, {7, 2, 5});
    add_box({-2, 1, 3}, {0, 2, 4});
    for(const Cell& cell : m_cells)
      add_sides(cell);
    polygons.push_back({vertex({1, 0, 4}), vertex({2, 0, 4}), vertex({3, 0, 4}), vertex({3, 1, 4}),
                        vertex({2, 1, 4}), vertex({2, 2, 4}), vertex({1, 2, 4}), vertex({1, 1, 4})});
  }

  // As OBJ
  std::string text() const
  {
    std::ostringstream text;
    text.precision(17);
    for(const Point& p : points)
      text << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for(const std::vector<std::size_t>& polygon : polygons) {
      text << 'f';
      for(const std::size_t v : polygon)
        text << ' ' << v + 1;
      text << '\n';
    }
    return text.str();
  }

  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;

private:
  using Cell = std::array<int, 3>;

  void add_box(const Cell& low, const Cell& high)
  {
    for(int x = low[0]; x < high[0]; ++x) {
      for(int y = low[1]; y < high[1]; ++y)
        for(int z = low[2]; z < high[2]; ++z)
          m_cells.insert({x, y, z});
    }
  }

  std::size_t vertex(const Cell& p)
  {
    const auto [place, is_new] = m_vertices.emplace(p, points.size());
    if(is_new) {
      points.push_back({p[0] + m_noise * m_random.gaussian(), p[1] + m_noise * m_random.gaussian(),
                        p[2] + m_noise * m_random.gaussian()});
    }
    return place->second;
  }

  static bool is_on_back(const Cell& cell, const std::size_t axis, const int step)
  {
    return axis == 2 && step == 1 && cell[2] == 3 &&
           ((cell[0] == 1 && cell[1] < 2) || (cell[0] == 2 && cell[1] == 0));
  }

  void add_sides(const Cell& cell)
  {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      for(const int step : {-1, 1}) {
        Cell beside = cell;
        beside[axis] += step;
        if(m_cells.count(beside) > 0 || is_on_back(cell, axis, step))
          continue;
        std::vector<std::size_t> side;
        for(const auto& [u, v] : std::vector<std::pair<int, int>>{{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
          Cell corner = cell;
          corner[axis] += step == 1;
          corner[(axis + 1) % 3] += step == 1 ? u : v;
          corner[(axis + 2) % 3] += step == 1 ? v : u;
          side.push_back(vertex(corner));
        }
        polygons.push_back(side);
      }
    }
  }

  Random m_random;
  double m_noise;
  std::set<Cell> m_cells;
  std::map<Cell, std::size_t> m_vertices;
};

} // namespace random_polygons

#endif // TEST_RANDOM_POLYGONS_H
