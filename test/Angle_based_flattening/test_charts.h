// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_TEST_CHARTS_H
#define ANGLE_BASED_FLATTENING_TEST_CHARTS_H

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Handmade charts for tests of single stages.
namespace test_charts {

namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;
typedef abf::Chart Chart;
typedef Chart::Point_2 Point_2;
typedef Chart::Point_3 Point_3;
typedef std::vector<std::array<int, 3>> Triangles;

// Glues triangles along equal edges.
inline Chart make_chart(const std::vector<Point_3>& points, const Triangles& triangles)
{
  Chart chart;
  chart.points = points;
  std::map<std::pair<int, int>, int> facing;
  for(const auto& triangle : triangles)
    for(int v : triangle)
      chart.vertex.push_back(v);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    facing[{chart.edge_source(c), chart.edge_target(c)}] = c;
  for(int c = 0; c < chart.number_of_corners(); ++c) {
    const auto across = facing.find({chart.edge_target(c), chart.edge_source(c)});
    chart.opposite.push_back(across == facing.end() ? -1 : across->second);
  }
  abf::find_borders(chart);
  return chart;
}

// A grid of (n + 1)^2 jittered vertices over the unit square, each cell cut along a random diagonal.
inline Chart grid(int n, unsigned int seed, const std::function<double(double, double)>& height)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::vector<Point_3> points;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j) {
      const double x = (i + jitter(random)) / n, y = (j + jitter(random)) / n;
      points.emplace_back(x, y, height(x, y));
    }
  Triangles triangles;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
      if(random() % 2) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      }
    }
  return make_chart(points, triangles);
}

inline Chart flat_grid(int n, unsigned int seed)
{
  return grid(n, seed, [](double, double) { return 0.; });
}

inline Chart bump(int n, unsigned int seed, double height = 0.5)
{
  return grid(n, seed, [height](double x, double y) {
    return height * std::exp(-8 * ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)));
  });
}

// A vertex at height `apex` above the origin, with `n` others around it.
inline Chart pyramid(int n, double apex)
{
  std::vector<Point_3> points{Point_3(0, 0, apex)};
  Triangles triangles;
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    triangles.push_back({0, i + 1, (i + 1) % n + 1});
  }
  return make_chart(points, triangles);
}

// A ring of two times `n` triangles.
inline Chart annulus(int n)
{
  std::vector<Point_3> points;
  Triangles triangles;
  for(int i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * i / n;
    const int a = 2 * i, b = a + 1, c = (a + 2) % (2 * n), d = (a + 3) % (2 * n);
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
    points.emplace_back(2 * std::cos(angle), 2 * std::sin(angle), 0);
    triangles.push_back({a, b, d});
    triangles.push_back({a, d, c});
  }
  return make_chart(points, triangles);
}

// A torus of n times n quadrangles without one of its triangles.
inline Chart torus_with_hole(int n)
{
  std::vector<Point_3> points;
  Triangles triangles;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const double s = 2 * CGAL_PI * i / n, t = 2 * CGAL_PI * j / n;
      points.emplace_back((3 + std::cos(t)) * std::cos(s), (3 + std::cos(t)) * std::sin(s), std::sin(t));
      const int a = i * n + j, b = (i + 1) % n * n + j, c = (i + 1) % n * n + (j + 1) % n,
                d = i * n + (j + 1) % n;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  triangles.pop_back();
  return make_chart(points, triangles);
}

inline std::vector<Point_2> projected(const Chart& chart)
{
  std::vector<Point_2> uv;
  for(const Point_3& p : chart.points)
    uv.emplace_back(p.x(), p.y());
  return uv;
}

inline std::vector<double> planar_angles(const Chart& chart, const std::vector<Point_2>& uv)
{
  std::vector<double> alpha;
  for(int c = 0; c < chart.number_of_corners(); ++c)
    alpha.push_back(abf::planar_angle(chart, uv, c));
  return alpha;
}

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_TEST_CHARTS_H
