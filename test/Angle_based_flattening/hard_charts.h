// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_HARD_CHARTS_H
#define ANGLE_BASED_FLATTENING_HARD_CHARTS_H

#include "test_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Charts that can be flattened, but only with difficulty. All random numbers come from `random`.
namespace test_charts {

inline double uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * (random() / 4294967296.);
}

inline int uniform_int(std::mt19937& random, int low, int high)
{
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

inline Point_3 random_point(std::mt19937& random)
{
  const double x = uniform(random, 0, 1), y = uniform(random, 0, 1), z = uniform(random, 0, 1);
  return Point_3(x, y, z);
}

// `height(x, y)` over the unit disk: a vertex and rings of 6, 12, 18... others around it.
inline Chart disk(int rings, const std::function<double(double, double)>& height)
{
  std::vector<Point_3> points{Point_3(0, 0, height(0, 0))};
  Triangles triangles;
  auto vertex = [](int ring, int i) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring); };
  for(int ring = 1; ring <= rings; ++ring) {
    for(int i = 0; i < 6 * ring; ++i) {
      const double radius = double(ring) / rings, angle = CGAL_PI / 3 * i / ring;
      const double x = radius * std::cos(angle), y = radius * std::sin(angle);
      points.emplace_back(x, y, height(x, y));
    }
    for(int sector = 0; sector < 6; ++sector)
      for(int j = 0; j < ring; ++j) {
        const int inner = vertex(ring - 1, sector * (ring - 1) + j), outer = vertex(ring, sector * ring + j),
                  next = vertex(ring, sector * ring + j + 1);
        triangles.push_back({inner, outer, next});
        if(j + 1 < ring)
          triangles.push_back({inner, next, vertex(ring - 1, sector * (ring - 1) + j + 1)});
      }
  }
  return make_chart(points, triangles);
}

inline Chart cone(int rings, double height)
{
  return disk(rings, [height](double x, double y) { return height * (1 - std::hypot(x, y)); });
}

inline Chart round_bump(int rings, double height)
{
  return disk(rings, [height](double x, double y) { return height * std::exp(-8 * (x * x + y * y)); });
}

inline Chart saddle(int rings, double height)
{
  return disk(rings, [height](double x, double y) { return height * (x * x - y * y); });
}

// Random heights, up to `amplitude` lengths of an edge.
inline Chart noisy_terrain(int n, double amplitude, std::mt19937& random)
{
  return grid(n, random(), [&](double, double) { return uniform(random, -amplitude, amplitude) / n; });
}

// Vertices of degree 3, each in a triangle that the previous vertex has made. The three of these are used in turn
// (`turning`), or all triangles share an edge.
inline Chart nested_insertions(int depth, bool turning, const std::function<Point_3(int)>& point)
{
  std::vector<Point_3> points{point(0), point(1), point(2)};
  Triangles triangles;
  std::array<int, 3> last{0, 1, 2};
  for(int i = 0; i < depth; ++i) {
    const int v = static_cast<int>(points.size());
    points.push_back(point(v));
    const int k = turning ? i % 3 : 2;
    for(int side = 0; side < 3; ++side)
      if(side != k) {
        std::array<int, 3> triangle = last;
        triangle[side] = v;
        triangles.push_back(triangle);
      }
    last[k] = v;
  }
  triangles.push_back(last);
  return make_chart(points, triangles);
}

// Quadrangles in a row, cut along diagonals: `point(i, side)` are their ends.
inline Chart ribbon(int n, const std::function<Point_3(int, int)>& point)
{
  std::vector<Point_3> points;
  Triangles triangles;
  for(int i = 0; i <= n; ++i) {
    points.push_back(point(i, 0));
    points.push_back(point(i, 1));
    if(i < n) {
      triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
      triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
    }
  }
  return make_chart(points, triangles);
}

inline Chart strip(int triangles)
{
  return ribbon(triangles / 2, [](int i, int side) { return Point_3(i, -side, 0); });
}

// In the plane, 48 quadrangles a turn.
inline Chart spiral(int n)
{
  return ribbon(n, [](int i, int side) {
    const double angle = CGAL_PI / 24 * i, radius = 1 + 0.02 * i + 0.5 * side;
    return Point_3(radius * std::cos(angle), radius * std::sin(angle), 0);
  });
}

// `columns` by `rows` quadrangles, cut along diagonals; `point(i, j)` are their corners.
inline Chart patch(int columns, int rows, const std::function<Point_3(int, int)>& point)
{
  std::vector<Point_3> points;
  Triangles triangles;
  for(int i = 0; i <= columns; ++i)
    for(int j = 0; j <= rows; ++j) {
      points.push_back(point(i, j));
      if(i < columns && j < rows) {
        const int a = i * (rows + 1) + j, b = a + rows + 1;
        triangles.push_back({a, b, b + 1});
        triangles.push_back({a, b + 1, a + 1});
      }
    }
  return make_chart(points, triangles);
}

// A ring, or with `height` a cylinder, cut open along a line.
inline Chart cut_annulus(int columns, int rows, double height)
{
  return patch(columns, rows, [=](int i, int j) {
    const double angle = -2 * CGAL_PI * i / columns, radius = height > 0 ? 1 : 1 + double(j) / rows;
    return Point_3(radius * std::cos(angle), radius * std::sin(angle), height * j / rows);
  });
}

// Teeth of `length` squares on a bar, with gaps of one square, over a surface with hills.
inline Chart comb(int teeth, int length, double hills)
{
  std::vector<Point_3> points;
  Triangles triangles;
  std::map<std::pair<int, int>, int> vertices;
  auto vertex = [&](int x, int y) {
    const auto [place, is_new] = vertices.insert({{x, y}, static_cast<int>(points.size())});
    if(is_new)
      points.emplace_back(x, y, hills * std::sin(x) * std::cos(0.7 * y));
    return place->second;
  };
  auto square = [&](int x, int y) {
    triangles.push_back({vertex(x, y), vertex(x + 1, y), vertex(x + 1, y + 1)});
    triangles.push_back({vertex(x, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
  };
  for(int x = 0; x < 2 * teeth - 1; ++x)
    for(int y = 0; y < (x % 2 == 0 ? length + 1 : 1); ++y)
      square(x, y);
  return make_chart(points, triangles);
}

// A vertex with `valence` neighbours at random distances and heights, with or without a second ring of triangles.
inline Chart star(int valence, bool two_rings, std::mt19937& random)
{
  std::vector<Point_3> points{Point_3(0, 0, 0)};
  Triangles triangles;
  for(int ring = 1; ring <= (two_rings ? 2 : 1); ++ring)
    for(int i = 0; i < valence; ++i) {
      const double radius = ring + uniform(random, -0.3, 0.3), angle = 2 * CGAL_PI * i / valence;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), uniform(random, -0.1, 0.1));
      const int v = i + 1, next = (i + 1) % valence + 1;
      if(ring == 1) {
        triangles.push_back({0, v, next});
      } else {
        triangles.push_back({v, v + valence, next + valence});
        triangles.push_back({v, next + valence, next});
      }
    }
  return make_chart(points, triangles);
}

// The closed unit sphere: an octahedron, whose triangles are quartered several times.
inline std::pair<std::vector<Point_3>, Triangles> sphere(int subdivisions)
{
  std::vector<Point_3> points{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  Triangles triangles;
  for(int i = 0; i < 4; ++i) {
    triangles.push_back({i, (i + 1) % 4, 4});
    triangles.push_back({(i + 1) % 4, i, 5});
  }
  for(int pass = 0; pass < subdivisions; ++pass) {
    std::map<std::pair<int, int>, int> middles;
    auto middle = [&](int v, int w) {
      const auto [place, is_new] = middles.insert({std::minmax(v, w), static_cast<int>(points.size())});
      if(is_new) {
        const auto sum = (points[v] - CGAL::ORIGIN) + (points[w] - CGAL::ORIGIN);
        points.push_back(CGAL::ORIGIN + sum / std::sqrt(sum.squared_length()));
      }
      return place->second;
    };
    Triangles finer;
    for(const auto& [a, b, c] : triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles.swap(finer);
  }
  return {points, triangles};
}

// A sphere slit along two edges. The vertex between them is duplicated.
inline Chart cut_sphere(int subdivisions, std::mt19937& random)
{
  auto [points, triangles] = sphere(subdivisions);
  const Chart closed = make_chart(points, triangles);
  const int first = uniform_int(random, 0, closed.number_of_corners() - 1);
  std::vector<int> fan{first};
  for(int c = closed.rotate(first); c != first; c = closed.rotate(c))
    fan.push_back(c);
  fan.resize(static_cast<std::size_t>(uniform_int(random, 1, static_cast<int>(fan.size()) - 1)));
  for(int c : fan)
    triangles[c / 3][c % 3] = static_cast<int>(points.size());
  const Point_3 doubled = points[closed.vertex[first]];
  points.push_back(doubled);
  return make_chart(points, triangles);
}

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_HARD_CHARTS_H
