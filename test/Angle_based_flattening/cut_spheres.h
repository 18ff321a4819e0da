// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_CUT_SPHERES_H
#define ANGLE_BASED_FLATTENING_CUT_SPHERES_H

#include "hard_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Closed surfaces of genus 0 that are cut open along trees of edges, so that they become disks. Their free-border maps
// often overlap themselves. All random numbers come from `random`.
namespace test_charts {

// A closed surface, on which a tree grows branch by branch.
class Tree_cut
{
  typedef std::pair<double, int> Reached; // the length of a path, and its last vertex

public:
  Tree_cut(const std::vector<Point_3>& points, const Triangles& triangles, int root)
      : m_closed(make_chart(points, triangles)), m_is_on_tree(points.size(), false), m_from(points.size()),
        m_neighbours(points.size())
  {
    m_is_on_tree[root] = true;
    for(int c = 0; c < m_closed.number_of_corners(); ++c)
      m_neighbours[m_closed.edge_source(c)].push_back(m_closed.edge_target(c));
  }

  // A shortest path from the tree to `target`. Each edge is longer by a random factor of up to `detour`, or not.
  void grow(int target, double detour, std::mt19937& random)
  {
    std::vector<double> length(m_closed.points.size(), (std::numeric_limits<double>::infinity)());
    std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> reached;
    for(int v = 0; v < m_closed.number_of_vertices(); ++v)
      if(m_is_on_tree[v]) {
        length[v] = 0;
        reached.push({0, v});
      }
    while(reached.top().second != target) {
      const auto [so_far, v] = reached.top();
      reached.pop();
      for(int w : m_neighbours[v]) {
        const double edge = std::sqrt(CGAL::squared_distance(m_closed.points[v], m_closed.points[w]));
        const double longer = so_far + edge * uniform(random, 1, detour);
        if(so_far == length[v] && longer < length[w]) {
          length[w] = longer;
          m_from[w] = v;
          reached.push({longer, w});
        }
      }
    }
    for(int v = target; !m_is_on_tree[v]; v = m_from[v]) {
      m_is_on_tree[v] = true;
      m_cut.insert(std::minmax(v, m_from[v]));
    }
  }

  int number_of_edges() const { return static_cast<int>(m_cut.size()); }

  // The triangles around a vertex stay together only where no edge of the tree is between them.
  Chart chart() const
  {
    std::vector<int> vertex(m_closed.vertex.size(), -1);
    std::vector<Point_3> points;
    for(int c = 0; c < m_closed.number_of_corners(); ++c) {
      if(vertex[c] >= 0)
        continue;
      std::vector<int> fan{c};
      while(!fan.empty()) {
        const int d = fan.back(), left = abf::previous_corner(d), right = abf::next_corner(d);
        fan.pop_back();
        vertex[d] = static_cast<int>(points.size());
        for(int next : {is_cut(left) ? d : abf::previous_corner(m_closed.opposite[left]),
                        is_cut(right) ? d : abf::next_corner(m_closed.opposite[right])})
          if(vertex[next] < 0)
            fan.push_back(next);
      }
      points.push_back(m_closed.points[m_closed.vertex[c]]);
    }
    Triangles triangles;
    for(std::size_t c = 0; c < vertex.size(); c += 3)
      triangles.push_back({vertex[c], vertex[c + 1], vertex[c + 2]});
    return make_chart(points, triangles);
  }

private:
  // The edge that a corner faces
  bool is_cut(int c) const
  {
    return m_cut.count(std::minmax(m_closed.edge_source(c), m_closed.edge_target(c))) > 0;
  }

  Chart m_closed;
  std::vector<char> m_is_on_tree;
  std::vector<int> m_from; // of each vertex that was reached: the one before it
  std::vector<std::vector<int>> m_neighbours;
  std::set<std::pair<int, int>> m_cut;
};

// A sphere with `number` bumps at random places, as high as `height` radii and as wide as a sphere divided by
// `sharpness`.
inline std::vector<Point_3> with_bumps(std::vector<Point_3> points, int number, double height,
                                       double sharpness, std::mt19937& random)
{
  std::vector<Point_3> peaks;
  for(int i = 0; i < number; ++i)
    peaks.push_back(points[uniform_int(random, 0, static_cast<int>(points.size()) - 1)]);
  for(Point_3& p : points) {
    double radius = 1;
    for(const Point_3& peak : peaks)
      radius += height * std::exp(-sharpness * CGAL::squared_distance(p, peak));
    p = Point_3(radius * p.x(), radius * p.y(), radius * p.z());
  }
  return points;
}

// Cut along a tree with that many branches, to random vertices and at least two edges long
inline Chart tree_cut(const std::vector<Point_3>& points, const Triangles& triangles, int branches,
                      double detour, std::mt19937& random)
{
  const int last = static_cast<int>(points.size()) - 1;
  Tree_cut cut(points, triangles, uniform_int(random, 0, last));
  for(int i = 0; i < branches || cut.number_of_edges() < 2; ++i)
    cut.grow(uniform_int(random, 0, last), detour, random);
  return cut.chart();
}

inline Chart tree_cut_sphere(int subdivisions, int branches, double detour, std::mt19937& random)
{
  const auto [points, triangles] = sphere(subdivisions);
  return tree_cut(points, triangles, branches, detour, random);
}

inline Chart tree_cut_bumps(int subdivisions, int branches, double height, double sharpness,
                            std::mt19937& random)
{
  const auto [points, triangles] = sphere(subdivisions);
  const int bumps = uniform_int(random, 1, 8);
  return tree_cut(with_bumps(points, bumps, height, sharpness, random), triangles, branches, 2, random);
}

// From pole to pole: the two sides of the slit are the whole border.
inline Chart slit_sphere(int subdivisions)
{
  const auto [points, triangles] = sphere(subdivisions);
  Tree_cut cut(points, triangles, 4);
  std::mt19937 unused;
  cut.grow(5, 1, unused);
  return cut.chart();
}

// The border has three vertices.
inline Chart sphere_without_triangle(int subdivisions, double stretch = 1)
{
  auto [points, triangles] = sphere(subdivisions);
  for(Point_3& p : points)
    p = Point_3(p.x(), p.y(), stretch * p.z());
  triangles.erase(triangles.begin());
  return make_chart(points, triangles);
}

// Such spheres in a chain, all at the same place, each joined to the next one by no more than an edge: a map has to
// shrink most of them.
inline Chart chain_of_bulbs(int bulbs, int subdivisions)
{
  auto [points, triangles] = sphere(subdivisions); // those of the bulb at hand
  const std::array<int, 3> mouth = triangles.front();
  std::vector<Point_3> all_points;
  Triangles all_triangles;
  std::vector<int> last; // of each vertex of a bulb: its number in the chart
  for(int bulb = 0; bulb < bulbs; ++bulb) {
    std::vector<int> vertices(points.size(), -1);
    if(bulb > 0) { // turned about the middle of an edge of the mouth, which is another one each time
      const int v = mouth[0], w = mouth[1 + bulb % 2];
      vertices[v] = last[w];
      vertices[w] = last[v];
      const auto axis = (points[v] - CGAL::ORIGIN) + (points[w] - CGAL::ORIGIN);
      for(Point_3& p : points)
        p = CGAL::ORIGIN + (2 * (axis * (p - CGAL::ORIGIN)) / (axis * axis) * axis - (p - CGAL::ORIGIN));
    }
    for(std::size_t v = 0; v < points.size(); ++v)
      if(vertices[v] < 0) {
        vertices[v] = static_cast<int>(all_points.size());
        all_points.push_back(points[v]);
      }
    for(std::size_t t = 1; t < triangles.size(); ++t)
      all_triangles.push_back(
          {vertices[triangles[t][0]], vertices[triangles[t][1]], vertices[triangles[t][2]]});
    last = vertices;
  }
  return make_chart(all_points, all_triangles);
}

} // namespace test_charts

#endif // ANGLE_BASED_FLATTENING_CUT_SPHERES_H
