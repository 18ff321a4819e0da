// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Rounds a map to `float` so that triangles keep their orientation where small moves of vertices do that.
// `atlas/build_atlas_impl.h` runs it on charts before they are certified, and the program `flatten_mesh` on other maps
// that it writes.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_POLYGONS_ROUND_TO_FLOATS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_POLYGONS_ROUND_TO_FLOATS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/float_grid.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_kernel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Triangles that rounding turns over, or leaves without area, first grow until they are some steps of the grid high:
// each by the shortest move of its corners, one after the other, until none makes another one too flat.
class Float_rounder
{
  typedef Exact_point_2 Point;
  typedef Planar_kernel::Vector_2 Vector;

public:
  // `vertex` holds the vertex of each corner.
  Float_rounder(const std::vector<int>& vertex, const Float_grid& grid, std::vector<Chart::Point_2>& uv)
      : m_number_of_triangles(static_cast<int>(vertex.size() / 3)), m_vertex(vertex), m_grid(grid), m_uv(uv),
        m_start(exact_points(uv)), m_points(m_start)
  {}

  // Both sides of a narrow slit stay apart as those of a needle do: the triangle outside of the region that the border
  // bounds, at each sharp corner, is treated as one of the map.
  void keep_gaps(const std::vector<Border_edge>& border)
  {
    std::vector<int> next(m_start.size(), -1);
    for(const Border_edge& e : border)
      next[e.source] = e.target;
    for(const Border_edge& e : border) {
      const int w = next[e.target];
      const Point &p = m_start[e.source], &q = m_start[e.target], &r = m_start[w];
      if((p - q) * (r - q) > 0 && is_positively_oriented(r, q, p))
        m_vertex.insert(m_vertex.end(), {w, e.target, e.source});
    }
  }

  // These vertices move by at most this much before they are rounded.
  void bound_moves(std::vector<char> is_bounded, double most_distance)
  {
    m_is_bounded = std::move(is_bounded);
    m_most_distance = most_distance;
  }

  // Returns the triangles that are not positively oriented all the same.
  std::vector<int> run()
  {
    std::vector<int> bad = round();
    if(!bad.empty()) {
      list_corners();
      enlarge(bad);
      bad = round();
    }
    const auto is_gap = [this](int t) { return t >= m_number_of_triangles; };
    bad.erase(std::remove_if(bad.begin(), bad.end(), is_gap), bad.end());
    return bad;
  }

private:
  // Each vertex moves by less than 3/4 of a step, and so does the line through two of them.
  static constexpr double least_height = 2;
  static constexpr double new_height = 3; // more, so that neighbors may take some of it

  static constexpr int most_moves = 1 << 20; // n needles side by side take about n^3

  std::vector<int> round()
  {
    std::vector<Point> rounded;
    for(const Point& p : m_points)
      rounded.push_back(m_grid.rounded_point(p));
    for(std::size_t v = 0; v < m_uv.size(); ++v)
      m_uv[v] = Chart::Point_2(rounded[v].x(), rounded[v].y());
    return flipped_triangles(m_vertex, rounded);
  }

  // The corners at each vertex
  void list_corners()
  {
    m_first.assign(m_points.size() + 1, 0);
    for(int v : m_vertex)
      ++m_first[v];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    m_corners.resize(m_vertex.size());
    for(std::size_t c = m_vertex.size(); c-- > 0;)
      m_corners[--m_first[m_vertex[c]]] = static_cast<int>(c);
  }

  void enlarge(const std::vector<int>& triangles)
  {
    std::deque<int> queue(triangles.begin(), triangles.end());
    std::vector<char> is_queued(m_vertex.size() / 3, false);
    for(int t : triangles)
      is_queued[t] = true;
    for(int moves = 0; moves < most_moves && !queue.empty();) {
      const int t = queue.front();
      queue.pop_front();
      is_queued[t] = false;
      if(!enlarge_triangle(t))
        continue;
      ++moves;
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        for(std::size_t k = m_first[m_vertex[c]]; k < m_first[m_vertex[c] + 1]; ++k)
          if(char& is_known = is_queued[m_corners[k] / 3]; !is_known) {
            is_known = true;
            queue.push_back(m_corners[k] / 3);
          }
    }
  }

  // Returns whether a vertex has moved.
  bool enlarge_triangle(int t)
  {
    const int* const v = &m_vertex[3 * t];
    Vector gradient[3]; // of twice the area
    double step = 0, squared_longest = 0, squares = 0;
    for(int i = 0; i < 3; ++i) {
      const Point& p = m_points[v[i]];
      const Vector side = m_points[v[(i + 2) % 3]] - m_points[v[(i + 1) % 3]];
      gradient[i] = Vector(-side.y(), side.x());
      step = (std::max)({step, m_grid.step(p.x()), m_grid.step(p.y())});
      squared_longest = (std::max)(squared_longest, side.squared_length());
      squares += side.squared_length();
    }
    const double area = 2 * CGAL::area(m_points[v[0]], m_points[v[1]], m_points[v[2]]),
                 area_of_step = step * std::sqrt(squared_longest);
    if(area >= least_height * area_of_step || !(squares > 0))
      return false;
    bool has_moved = false;
    for(int i = 0; i < 3; ++i) {
      const Point old = m_points[v[i]];
      move(v[i], old + (new_height * area_of_step - area) / squares * gradient[i]);
      has_moved = has_moved || m_points[v[i]] != old;
    }
    return has_moved;
  }

  void move(int v, const Point& point)
  {
    m_points[v] = point;
    const Vector way = point - m_start[v];
    const double distance = std::sqrt(way.squared_length());
    if(!m_is_bounded.empty() && m_is_bounded[v] && distance > m_most_distance)
      m_points[v] = m_start[v] + m_most_distance / distance * way;
  }

  const int m_number_of_triangles; // of the map; gaps follow them
  std::vector<int> m_vertex;
  const Float_grid m_grid;
  std::vector<Chart::Point_2>& m_uv;
  const std::vector<Point> m_start;
  std::vector<Point> m_points;
  std::vector<std::size_t> m_first; // of each vertex, in `m_corners`, and the number of corners
  std::vector<int> m_corners;
  std::vector<char> m_is_bounded; // of each vertex, or empty
  double m_most_distance = 0;     // of these
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_POLYGONS_ROUND_TO_FLOATS_H
