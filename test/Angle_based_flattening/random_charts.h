// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_RANDOM_CHARTS_H
#define ANGLE_BASED_FLATTENING_RANDOM_CHARTS_H

#include "hard_charts.h"

#include <map>
#include <random>
#include <utility>
#include <vector>

// Disks without parallel edges, which can therefore be flattened. Their points are not those of a real surface:
// random, coincident, or collinear.
namespace test_charts {

// Connectivity at random: triangles are split, edges are flipped, and triangles are put onto the border.
class Random_triangulation
{
public:
  Random_triangulation(int operations, std::mt19937& random)
  {
    add({0, 1, 2});
    for(int i = 0; i < operations; ++i) {
      const int corner = uniform_int(random, 0, 3 * static_cast<int>(m_triangles.size()) - 1);
      const unsigned choice = random() % 10;
      if(choice < 3)
        split(corner / 3);
      else if(!flip(corner / 3, corner % 3) && choice < 6)
        put_onto_border(corner / 3, corner % 3);
    }
  }

  int number_of_vertices() const { return m_vertices; }
  const Triangles& triangles() const { return m_triangles; }

private:
  typedef std::array<int, 3> Triangle;

  void set(int t, const Triangle& triangle)
  {
    m_triangles[t] = triangle;
    for(int k = 0; k < 3; ++k)
      m_left[{triangle[k], triangle[(k + 1) % 3]}] = t;
  }

  void add(const Triangle& triangle)
  {
    m_triangles.emplace_back();
    set(static_cast<int>(m_triangles.size()) - 1, triangle);
  }

  void split(int t)
  {
    const auto [a, b, c] = m_triangles[t];
    const int v = m_vertices++;
    set(t, {a, b, v});
    add({b, c, v});
    add({c, a, v});
  }

  bool flip(int t, int k)
  {
    const int a = m_triangles[t][k], b = m_triangles[t][(k + 1) % 3], c = m_triangles[t][(k + 2) % 3];
    const auto across = m_left.find({b, a});
    if(across == m_left.end())
      return false;
    const int other = across->second;
    int d = 0;
    for(int v : m_triangles[other])
      if(v != a && v != b)
        d = v;
    if(m_left.count({c, d}) + m_left.count({d, c}) > 0)
      return true;
    m_left.erase({a, b});
    m_left.erase({b, a});
    set(t, {a, d, c});
    set(other, {d, b, c});
    return true;
  }

  void put_onto_border(int t, int k)
  {
    add({m_triangles[t][(k + 1) % 3], m_triangles[t][k], m_vertices});
    ++m_vertices;
  }

  int m_vertices = 3;
  Triangles m_triangles;
  std::map<std::pair<int, int>, int> m_left; // the triangle to the left of each edge from vertex to vertex
};

// Any connectivity, with random points in space.
inline Chart random_chart(int operations, std::mt19937& random)
{
  const Random_triangulation triangulation(operations, random);
  std::vector<Point_3> points;
  for(int v = 0; v < triangulation.number_of_vertices(); ++v)
    points.push_back(random_point(random));
  return make_chart(points, triangulation.triangles());
}

// In some triangles, a corner is moved to the opposite edge, up to `distance` relative to the edge.
inline Chart slivers(Chart chart, int number, double distance, std::mt19937& random)
{
  for(int i = 0; i < number; ++i) {
    const int c = uniform_int(random, 0, chart.number_of_corners() - 1);
    const Point_3 p = chart.points[chart.edge_source(c)], q = chart.points[chart.edge_target(c)];
    const Point_3 r = p + uniform(random, 0, 1) * (q - p);
    chart.points[chart.vertex[c]] = r + distance * (chart.points[chart.vertex[c]] - r);
  }
  return chart;
}

// Vertices at the positions of their neighbours.
inline Chart duplicated_points(Chart chart, int number, std::mt19937& random)
{
  for(int i = 0; i < number; ++i) {
    const int c = uniform_int(random, 0, chart.number_of_corners() - 1);
    chart.points[chart.edge_target(c)] = chart.points[chart.edge_source(c)];
  }
  return chart;
}

inline Chart in_a_line(Chart chart)
{
  for(Point_3& p : chart.points)
    p = Point_3(p.x() + p.y(), 0, 0);
  return chart;
}

inline Chart in_a_point(Chart chart)
{
  for(Point_3& p : chart.points)
    p = Point_3(1, 2, 3);
  return chart;
}

inline Chart scaled(Chart chart, double factor)
{
  for(Point_3& p : chart.points)
    p = Point_3(factor * p.x(), factor * p.y(), factor * p.z());
  return chart;
}

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_RANDOM_CHARTS_H
