// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves vertices of a finished map a little, until the polygons that were divided into triangles are convex in the
// plane. `atlas/build_atlas_impl.h` runs it before charts are packed, and the program `flatten_mesh` on single maps.
//
// Tests whether a polygon in the plane is strictly convex, also after rounding to `float`.
// `make_polygons_convex.h` mends what fails them: readers triangulate polygons as fans, which may turn over at a
// concave corner.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_POLYGONS_MAKE_POLYGONS_CONVEX_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_POLYGONS_MAKE_POLYGONS_CONVEX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/float_grid.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_kernel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Readers draw a polygon as a fan of triangles from any corner, and many of them round coordinates to `float` before.
// All these triangles are positively oriented if the polygon is strictly convex, before and after.
//
// Rounding moves a corner, and the line through its neighbors, by less than 3/4 of the grid's step each. A corner that
// is two steps off the line turns left before and after, and one that is straight counts as straight wherever it is.
inline bool turns_left(const Exact_point_2& p, const Exact_point_2& q, const Exact_point_2& r,
                       const Float_grid& grid)
{
  double step = 0;
  for(double x : {p.x(), p.y(), q.x(), q.y(), r.x(), r.y()})
    step = (std::max)(step, grid.step(x));
  return 2 * CGAL::area(p, q, r) > 2 * step * std::sqrt(CGAL::squared_distance(p, r)) &&
         CGAL::orientation(p, q, r) == CGAL::LEFT_TURN;
}

// The number of corners at which the polygon does not turn left
inline std::size_t count_bad_corners(const std::vector<Exact_point_2>& polygon, const Float_grid& grid)
{
  const std::size_t size = polygon.size();
  std::size_t count = 0;
  for(std::size_t i = 0; i < size; ++i)
    count += !turns_left(polygon[i], polygon[(i + 1) % size], polygon[(i + 2) % size], grid);
  return count;
}

// Whether all fans are good. A polygon that turns left everywhere is convex if it goes around once: if only one corner
// is to the left of both its neighbors.
inline bool is_strictly_convex(const std::vector<Exact_point_2>& polygon, const Float_grid& grid)
{
  const std::size_t size = polygon.size();
  std::size_t leftmost = 0;
  for(std::size_t i = 0; i < size; ++i)
    leftmost += polygon[(i + 1) % size] < polygon[i] && polygon[(i + 1) % size] < polygon[(i + 2) % size];
  return leftmost == 1 && count_bad_corners(polygon, grid) == 0;
}

// Triangles as a corner table (see `Chart`), with the diagonals of larger polygons
struct Divided_polygons
{
  std::vector<int> vertex, opposite; // of each corner
  std::vector<char> is_diagonal;     // of each corner: the edge that it faces
  std::vector<char> is_fixed;        // of each vertex

  int number_of_corners() const { return static_cast<int>(vertex.size()); }
};

// Moves vertices of a map a little, so that polygons become strictly convex. No triangle is turned over, no convex
// polygon is spoiled, and borders stay where they are.
class Polygon_mender
{
  typedef Exact_point_2 Point;
  typedef Planar_kernel::Vector_2 Vector;

public:
  Polygon_mender(const Divided_polygons& polygons, const Float_grid& grid, std::vector<Chart::Point_2>& uv)
      : m_table(polygons), m_grid(grid), m_uv(uv), m_points(exact_points(uv)), m_start(m_points),
        m_polygon(polygons.number_of_corners() / 3, -1), m_corner(uv.size(), -1)
  {
    for(int c = 0; c < m_table.number_of_corners(); ++c)
      m_corner[m_table.vertex[c]] = c;
    for(int t = 0; t < m_table.number_of_corners() / 3; ++t)
      if(m_polygon[t] == -1)
        find_polygon(t);
  }

  // Returns how many polygons are convex that were not before. If there are none, nothing has moved.
  std::size_t run()
  {
    const int rounds = 10;
    std::vector<int> bad(number_of_polygons());
    std::iota(bad.begin(), bad.end(), 0);
    remove_convex(bad);
    const std::size_t before = bad.size();
    for(int round = 0; round < rounds && !bad.empty(); ++round) {
      bool has_moved = false;
      for(int p : bad)
        has_moved = mend(p) || has_moved;
      if(!has_moved)
        break;
      remove_convex(bad);
    }
    for(std::size_t v = 0; v < m_uv.size() && bad.size() < before; ++v)
      m_uv[v] = Chart::Point_2(m_points[v].x(), m_points[v].y());
    return before - bad.size();
  }

private:
  bool is_diagonal(int c) const { return m_table.opposite[c] >= 0 && m_table.is_diagonal[c]; }
  int number_of_polygons() const { return static_cast<int>(m_first.size()) - 1; }

  void find_polygon(int t)
  {
    std::vector<int> triangles = {t};
    const int number = number_of_polygons();
    m_polygon[t] = number;
    int side = -1;
    for(std::size_t i = 0; i < triangles.size(); ++i)
      for(int c = 3 * triangles[i]; c < 3 * triangles[i] + 3; ++c)
        if(!is_diagonal(c))
          side = c;
        else if(int& next = m_polygon[m_table.opposite[c] / 3]; next != number) {
          next = number;
          triangles.push_back(m_table.opposite[c] / 3);
        }
    if(triangles.size() == 1 || side < 0) {
      for(int other : triangles)
        m_polygon[other] = no_polygon;
      return;
    }
    int c = side;
    do {
      m_loop.push_back(m_table.vertex[next_corner(c)]);
      c = next_corner(c);
      while(is_diagonal(c))
        c = next_corner(m_table.opposite[c]);
    } while(c != side);
    m_first.push_back(m_loop.size());
  }

  std::vector<Point> points_of(int polygon) const
  {
    std::vector<Point> points;
    for(std::size_t i = m_first[polygon]; i < m_first[polygon + 1]; ++i)
      points.push_back(m_points[m_loop[i]]);
    return points;
  }

  void remove_convex(std::vector<int>& polygons) const
  {
    polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                                  [this](int p) { return is_strictly_convex(points_of(p), m_grid); }),
                   polygons.end());
  }

  // Returns whether a vertex has moved.
  bool mend(int polygon)
  {
    const std::size_t first = m_first[polygon], size = m_first[polygon + 1] - first;
    bool has_moved = false;
    for(std::size_t i = 0; i < size; ++i) {
      const int u = m_loop[first + i], v = m_loop[first + (i + 1) % size], w = m_loop[first + (i + 2) % size];
      if(!turns_left(m_points[u], m_points[v], m_points[w], m_grid))
        has_moved = mend_corner(u, v, w) || has_moved;
    }
    return has_moved;
  }

  // Moves one of them until it is to the left of the line through the other two.
  bool mend_corner(int u, int v, int w)
  {
    for(double share : {0.05, 0.02, 0.005})
      if(move_to_left(v, w, u, share) || move_to_left(u, v, w, share) || move_to_left(w, u, v, share))
        return true;
    return false;
  }

  bool move_to_left(int v, int from, int to, double share)
  {
    const Vector line = m_points[to] - m_points[from];
    const double length = std::sqrt(line.squared_length());
    if(m_table.is_fixed[v] || !(length > 0))
      return false;
    const Vector left(-line.y() / length, line.x() / length);
    const double missing = share * length - (m_points[v] - m_points[from]) * left;
    return move(v, m_grid.rounded_point(m_points[v] + missing * left));
  }

  std::vector<int> star(int v) const
  {
    std::vector<int> corners;
    int c = m_corner[v];
    do {
      corners.push_back(c);
      c = previous_corner(m_table.opposite[previous_corner(c)]);
    } while(c != m_corner[v]);
    return corners;
  }

  // A quarter of the shortest edge there was
  bool is_near_start(int v, const Point& point, const std::vector<int>& star) const
  {
    double shortest = CGAL::squared_distance(m_start[v], m_start[m_table.vertex[next_corner(star[0])]]);
    for(int c : star)
      shortest =
          (std::min)(shortest, CGAL::squared_distance(m_start[v], m_start[m_table.vertex[next_corner(c)]]));
    return CGAL::squared_distance(m_start[v], point) <= shortest / 16;
  }

  double area(const std::vector<Point>& points, int c) const
  {
    return CGAL::area(points[m_table.vertex[c]], points[m_table.vertex[next_corner(c)]],
                      points[m_table.vertex[previous_corner(c)]]);
  }

  std::vector<std::size_t> bad_corners(const std::vector<int>& polygons) const
  {
    std::vector<std::size_t> result;
    for(int p : polygons)
      result.push_back(count_bad_corners(points_of(p), m_grid));
    return result;
  }

  // Moves a vertex if this lowers the number of bad corners, raises it in no polygon, and leaves each triangle half of
  // its first area.
  bool move(int v, const Point& point)
  {
    const std::vector<int> corners = star(v);
    if(!is_near_start(v, point, corners))
      return false;
    std::vector<int> polygons;
    for(int c : corners)
      if(m_polygon[c / 3] != no_polygon)
        polygons.push_back(m_polygon[c / 3]);
    std::sort(polygons.begin(), polygons.end());
    polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
    const std::vector<std::size_t> before = bad_corners(polygons);
    const Point old = m_points[v];
    m_points[v] = point;
    const std::vector<std::size_t> after = bad_corners(polygons);
    bool is_better = before != after;
    for(std::size_t i = 0; i < polygons.size(); ++i)
      is_better = is_better && after[i] <= before[i];
    for(int c : corners)
      is_better = is_better && area(m_points, c) > area(m_start, c) / 2 &&
                  turns_left(point, m_points[m_table.vertex[next_corner(c)]],
                             m_points[m_table.vertex[previous_corner(c)]], m_grid);
    if(!is_better)
      m_points[v] = old;
    return is_better;
  }

  static constexpr int no_polygon = -2; // of triangles

  const Divided_polygons& m_table;
  const Float_grid m_grid; // of vertices that are moved
  std::vector<Chart::Point_2>& m_uv;
  std::vector<Point> m_points, m_start;
  std::vector<int> m_polygon;             // of each triangle
  std::vector<int> m_corner;              // of each vertex: one of its corners
  std::vector<int> m_loop;                // the vertices of all polygons with more than three corners
  std::vector<std::size_t> m_first = {0}; // of each polygon, in `m_loop`, and their number
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_POLYGONS_MAKE_POLYGONS_CONVEX_H
