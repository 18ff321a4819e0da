// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Plane layouts of patches: how one unfolds, for `crease_patches.h`; motions that lay one beside another, and whether
// the two then overlap, for `crease_division_impl.h`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PATCH_LAYOUTS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PATCH_LAYOUTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/centroid.h>
#include <CGAL/Dimension.h>
#include <CGAL/Origin.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Twice as long as the area is large
inline Corner_table::Kernel::Vector_3 triangle_normal(const Corner_table& table, int t)
{
  const auto& p = table.points[table.vertex[3 * t]];
  return CGAL::cross_product(table.points[table.vertex[3 * t + 1]] - p,
                             table.points[table.vertex[3 * t + 2]] - p);
}

// Looks whether some triangles lie in a plane, with the same side up.
class Flat_layout
{
  typedef Corner_table::Kernel::Vector_3 Vector_3;

public:
  Flat_layout(const Corner_table& table, const std::vector<int>& triangles)
      : m_origin(table.points[table.vertex[3 * triangles.front()]])
  {
    Vector_3 normal = CGAL::NULL_VECTOR;
    for(int t : triangles)
      normal = normal + triangle_normal(table, t);
    if(!(normal.squared_length() > 0))
      return;
    normal = unit(normal);
    m_x =
        unit(CGAL::cross_product(std::abs(normal.x()) < 0.6 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0), normal));
    m_y = CGAL::cross_product(normal, m_x);
    for(int t : triangles) {
      const Vector_3 n = triangle_normal(table, t);
      if(!(n * normal > least_cosine * std::sqrt(n.squared_length())))
        return;
    }
    m_is_flat = true;
  }

  bool is_flat() const { return m_is_flat; }

  Corner_table::Point_2 operator()(const Corner_table::Point_3& p) const
  {
    return Corner_table::Point_2((p - m_origin) * m_x, (p - m_origin) * m_y);
  }

private:
  static constexpr double least_cosine = 1 - 1e-4; // changes angles by less than 0.003 degrees

  static Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

  Corner_table::Point_3 m_origin;
  Vector_3 m_x, m_y;
  bool m_is_flat = false;
};

// A length in a layout may be wrong by this part of the square root of the area.
inline constexpr double layout_tolerance = 2e-3;

// Whether the edge that a corner faces lies within a patch. `patch` is that of each triangle.
inline bool is_within_patch(const Corner_table& surface, const std::vector<int>& patch, int c)
{
  return surface.opposite[c] >= 0 && patch[surface.opposite[c] / 3] == patch[c / 3];
}

// Lays patches out triangle by triangle, across long edges first.
class Patch_unfolding
{
  typedef Corner_table::Kernel::Vector_2 Vector_2;
  typedef Corner_table::Kernel::Vector_3 Vector_3;
  typedef Corner_table::Point_2 Point_2;

public:
  // `patch` is that of each triangle, and `layout` receives the place of each corner.
  Patch_unfolding(const Corner_table& surface, const std::vector<int>& patch, std::vector<Point_2>& layout)
      : m_surface(surface), m_patch(patch), m_layout(layout),
        m_is_laid_out(surface.number_of_triangles(), false)
  {}

  // Lays out all triangles of a patch, and returns whether they fit together.
  bool run(const std::vector<int>& triangles, double area)
  {
    typedef std::pair<double, int> Entry; // length of an edge, and the corner that faces it from outside
    std::priority_queue<Entry> queue;
    const auto add = [&](int t) {
      m_is_laid_out[t] = true;
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        if(is_within_patch(m_surface, m_patch, c))
          queue.emplace(edge_length(m_surface, c), m_surface.opposite[c]);
    };
    const auto is_smaller = [&](int s, int t) {
      return surface_area(m_surface, s) < surface_area(m_surface, t);
    };
    const int first = *std::max_element(triangles.begin(), triangles.end(), is_smaller);
    m_layout[3 * first] = Point_2(0, 0);
    m_layout[3 * first + 1] = Point_2(edge_length(m_surface, 3 * first + 2), 0);
    place(3 * first + 2);
    add(first);
    while(!queue.empty()) {
      Deadline::ask();
      const int c = queue.top().second, across = m_surface.opposite[c];
      queue.pop();
      if(m_is_laid_out[c / 3])
        continue;
      m_layout[next_corner(c)] = m_layout[previous_corner(across)];
      m_layout[previous_corner(c)] = m_layout[next_corner(across)];
      place(c);
      add(c / 3);
    }
    return fits_together(triangles, area);
  }

private:
  // Places a corner on the left of the edge that it faces.
  void place(int c)
  {
    const auto point = [&](int corner) { return m_surface.points[m_surface.vertex[corner]]; };
    const Vector_3 side = point(previous_corner(c)) - point(next_corner(c)),
                   v = point(c) - point(next_corner(c));
    const Point_2& p = m_layout[next_corner(c)];
    const Vector_2 e = m_layout[previous_corner(c)] - p;
    const double square = side.squared_length();
    const double along = square > 0 ? v * side / square : 0,
                 across = square > 0 ? std::sqrt(CGAL::cross_product(side, v).squared_length()) / square : 0;
    m_layout[c] = p + along * e + across * Vector_2(-e.y(), e.x());
  }

  bool fits_together(const std::vector<int>& triangles, double area) const
  {
    const double square = layout_tolerance * layout_tolerance * area;
    for(int t : triangles)
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        if(is_within_patch(m_surface, m_patch, c) &&
           CGAL::squared_distance(m_layout[next_corner(c)],
                                  m_layout[previous_corner(m_surface.opposite[c])]) > square)
          return false;
    return true;
  }

  const Corner_table& m_surface;
  const std::vector<int>& m_patch;
  std::vector<Point_2>& m_layout;
  std::vector<char> m_is_laid_out;
};

// A rotation and a translation. (Eigen::umeyama() fits one too, but g++ 12 gives false warnings inside of it.)
class Planar_motion
{
  typedef Corner_table::Kernel::Vector_2 Vector_2;
  typedef Corner_table::Point_2 Point_2;

public:
  // Moves each point `from[i]` as near as possible to `to[i]`. There is at least one.
  Planar_motion(const std::vector<Point_2>& from, const std::vector<Point_2>& to)
      : m_from(centroid(from)), m_to(centroid(to))
  {
    double c = 0, s = 0;
    for(std::size_t i = 0; i < from.size(); ++i) {
      const Vector_2 v = from[i] - m_from, w = to[i] - m_to;
      c += v * w;
      s += v.x() * w.y() - v.y() * w.x();
    }
    if(const double length = std::hypot(c, s); length > 0) {
      m_cosine = c / length;
      m_sine = s / length;
    }
  }

  Point_2 operator()(const Point_2& p) const
  {
    const Vector_2 v = p - m_from;
    return m_to + Vector_2(m_cosine * v.x() - m_sine * v.y(), m_sine * v.x() + m_cosine * v.y());
  }

private:
  static Point_2 centroid(const std::vector<Point_2>& points)
  {
    return CGAL::centroid(points.begin(), points.end(), CGAL::Dimension_tag<0>());
  }

  Point_2 m_from, m_to;
  double m_cosine = 1, m_sine = 0;
};

// Cells of a grid whose centres triangles cover. Two layers tell whether two sets of triangles overlap.
class Covered_cells
{
  typedef Corner_table::Point_2 Point_2;

public:
  Covered_cells(const CGAL::Bbox_2& box, double cell)
      : m_x(box.xmin()), m_y(box.ymin()), m_cell(cell),
        m_width(1 + static_cast<int>((box.xmax() - m_x) / cell)),
        m_height(1 + static_cast<int>((box.ymax() - m_y) / cell)),
        m_layers(static_cast<std::size_t>(m_width) * m_height, 0)
  {}

  void cover(const std::array<Point_2, 3>& triangle, char layer)
  {
    const auto [low, high] = std::minmax({triangle[0].y(), triangle[1].y(), triangle[2].y()});
    const int last = first_centre(high - m_y, m_height);
    for(int y = first_centre(low - m_y, m_height); y < last; ++y) {
      const double height = m_y + (y + 0.5) * m_cell;
      double left = std::numeric_limits<double>::infinity(), right = -left;
      for(int i = 0; i < 3; ++i) {
        const Point_2 &p = triangle[i], &q = triangle[(i + 1) % 3];
        if((p.y() <= height) == (q.y() <= height))
          continue;
        const double x = p.x() + (height - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
        left = (std::min)(left, x);
        right = (std::max)(right, x);
      }
      const int end = first_centre(right - m_x, m_width);
      for(int x = first_centre(left - m_x, m_width); x < end; ++x)
        m_layers[index(x, y)] |= layer;
    }
  }

  // The area of all cells in all `layers` that have such neighbours: the common border of two sets of triangles does
  // not count.
  double common_area(char layers) const
  {
    const auto is_in = [&](int x, int y) { return (m_layers[index(x, y)] & layers) == layers; };
    int count = 0;
    for(int y = 0; y + 1 < m_height; ++y)
      for(int x = 0; x + 1 < m_width; ++x)
        count += is_in(x, y) && is_in(x + 1, y) && is_in(x, y + 1) && is_in(x + 1, y + 1);
    return count * m_cell * m_cell;
  }

private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * m_width + x; }

  // The first cell whose centre is at a distance or behind it
  int first_centre(double distance, int cells) const
  {
    return static_cast<int>(std::ceil((std::clamp)(distance / m_cell - 0.5, 0., static_cast<double>(cells))));
  }

  double m_x, m_y, m_cell;
  int m_width, m_height;
  std::vector<char> m_layers; // of each cell: a bit for each
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PATCH_LAYOUTS_H
