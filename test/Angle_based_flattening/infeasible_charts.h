// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_INFEASIBLE_CHARTS_H
#define ANGLE_BASED_FLATTENING_INFEASIBLE_CHARTS_H

#include "hard_charts.h"

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>

#include <limits>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Charts that have no map to the plane or are not allowed, with the expected diagnosis.
namespace test_charts {

typedef CGAL::Surface_mesh_parameterization::Diagnosis Diagnosis;

struct Infeasible_chart
{
  Chart chart;
  Diagnosis status;
  std::vector<std::set<int>> offenders; // the vertices to name: one of these sets
};

inline int interior_edge(const Chart& chart, std::mt19937& random)
{
  int c;
  do
    c = uniform_int(random, 0, chart.number_of_corners() - 1);
  while(chart.opposite[c] < 0);
  return c;
}

inline void glue(Chart& chart, int c, int d)
{
  chart.opposite[c] = d;
  chart.opposite[d] = c;
}

// Opens the edge that corner `c` faces, and puts triangles between its two sides, which become parallel edges. The last
// corner of the first triangle faces the edge on the side of `c`, the last one of the second faces the other.
inline Chart open_edge(Chart chart, int c, int new_vertices, const Triangles& triangles)
{
  const int across = chart.opposite[c], first = chart.number_of_corners();
  const Point_3 middle =
      CGAL::midpoint(chart.points[chart.edge_source(c)], chart.points[chart.edge_target(c)]);
  for(int i = 0; i < new_vertices; ++i)
    chart.points.emplace_back(middle.x(), middle.y(), middle.z() + 0.1 * (i + 1));
  for(const auto& triangle : triangles)
    chart.vertex.insert(chart.vertex.end(), triangle.begin(), triangle.end());
  chart.opposite.resize(chart.vertex.size(), -1);
  glue(chart, c, first + 2);
  glue(chart, across, first + 5);
  std::map<std::pair<int, int>, int> facing;
  for(int d = first; d < chart.number_of_corners(); ++d)
    if(chart.opposite[d] < 0) {
      const auto other = facing.find({chart.edge_target(d), chart.edge_source(d)});
      if(other != facing.end())
        glue(chart, d, other->second);
      facing[{chart.edge_source(d), chart.edge_target(d)}] = d;
    }
  find_borders(chart);
  return chart;
}

inline Infeasible_chart parallel_edges(const Chart& chart, std::mt19937& random)
{
  const int c = interior_edge(chart, random), a = chart.edge_source(c), b = chart.edge_target(c);
  const int v = chart.number_of_vertices(), w = v + 1;
  return {open_edge(chart, c, 2, {{b, a, v}, {a, b, w}, {v, a, w}, {b, v, w}}),
          Diagnosis::PARALLEL_EDGES,
          {{a, b}}};
}

inline Infeasible_chart interior_degree_2(const Chart& chart, std::mt19937& random)
{
  const int c = interior_edge(chart, random), a = chart.edge_source(c), b = chart.edge_target(c);
  const int v = chart.number_of_vertices();
  return {open_edge(chart, c, 1, {{b, a, v}, {a, b, v}}), Diagnosis::PARALLEL_EDGES, {{a, b}}};
}

// A loop surrounds it.
inline Infeasible_chart interior_degree_1(Chart chart, std::mt19937& random)
{
  const int c = interior_edge(chart, random), a = chart.edge_source(c), b = chart.edge_target(c);
  const int across = chart.opposite[c], first = chart.number_of_corners(), v = chart.number_of_vertices();
  chart.points.push_back(random_point(random));
  chart.vertex.insert(chart.vertex.end(), {b, a, a, a, a, v});
  chart.opposite.resize(chart.vertex.size(), -1);
  glue(chart, c, first + 2);
  glue(chart, across, first + 1);
  glue(chart, first, first + 5);
  glue(chart, first + 3, first + 4);
  find_borders(chart);
  return {chart, Diagnosis::PARALLEL_EDGES, {{a}, {a, b}}};
}

// A sphere slit along a single edge: that edge is the border, twice.
inline Infeasible_chart slit_edge(int subdivisions, std::mt19937& random)
{
  const auto [points, triangles] = sphere(subdivisions);
  Chart chart = make_chart(points, triangles);
  const int c = interior_edge(chart, random);
  chart.opposite[chart.opposite[c]] = -1;
  chart.opposite[c] = -1;
  find_borders(chart);
  return {chart, Diagnosis::PARALLEL_EDGES, {{chart.edge_source(c), chart.edge_target(c)}}};
}

// A strip whose surface meets itself in one vertex.
inline Infeasible_chart bow_tie(int n, std::mt19937& random)
{
  Chart chart = patch(n, 2, [](int i, int j) { return Point_3(i, -j, 0.1 * i); });
  const int v = uniform_int(random, 0, 2), last = chart.number_of_vertices() - 1;
  for(int& w : chart.vertex) // the last vertex, a corner of the patch, is put onto one at the other end
    w = w == last ? v : w;
  chart.points.pop_back();
  find_borders(chart);
  return {chart, Diagnosis::NON_MANIFOLD_VERTEX, {{v}}};
}

inline Infeasible_chart non_finite_point(Chart chart, std::mt19937& random)
{
  const int v = uniform_int(random, 0, chart.number_of_vertices() - 1);
  double coordinates[3] = {0, 0, 0};
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const double bad[3] = {nan, infinity, -infinity};
  coordinates[random() % 3] = bad[random() % 3];
  chart.points[v] = Point_3(coordinates[0], coordinates[1], coordinates[2]);
  return {chart, Diagnosis::NON_FINITE_POINT, {{v}}};
}

// The vertex to be named is any of the second border.
inline Infeasible_chart two_borders(int n)
{
  const Chart chart = annulus(n);
  Infeasible_chart result{chart, Diagnosis::SEVERAL_BORDERS, {}};
  for(int c : chart.borders[1])
    result.offenders.push_back({chart.edge_source(c)});
  return result;
}

inline Infeasible_chart handle(int n)
{
  return {torus_with_hole(n), Diagnosis::NONZERO_GENUS, {{}}};
}

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_INFEASIBLE_CHARTS_H
