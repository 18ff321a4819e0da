// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The triangles, borders and seams of a chart as a corner table, without a mesh: connectivity and points.
// `chart.h` adds what the planar angles must fulfil. Certificates, measures and layouts need the table only.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_CORNER_TABLE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_CORNER_TABLE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/inline.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Corner `c` is a corner of triangle `c / 3`; the corners of a triangle are counterclockwise. (Remainders of unsigned
// numbers take less time.)
inline int next_corner(int c)
{
  return static_cast<unsigned>(c) % 3 == 2 ? c - 2 : c + 1;
}

inline int previous_corner(int c)
{
  return static_cast<unsigned>(c) % 3 == 0 ? c + 2 : c - 1;
}

// A connected triangulated surface with border, as a corner table: all that the stages behind `read_chart()`
// know of a mesh. Corner `c` faces the edge from `vertex[next_corner(c)]` to `vertex[previous_corner(c)]`.
struct Corner_table
{
  typedef CGAL::Simple_cartesian<double> Kernel; // the certificate takes exact predicates
  typedef Kernel::Point_2 Point_2;
  typedef Kernel::Point_3 Point_3;

  std::vector<Point_3> points;         // of each vertex, divided by `scale`
  double scale = 1;                    // a power of two, so that squares neither overflow nor vanish
  std::vector<std::ptrdiff_t> numbers; // of each vertex, for messages; vertices behind the last one have none
  std::vector<int> vertex;             // of each corner
  std::vector<int> opposite;           // of each corner: the one that faces the same edge, -1 at the border
  std::vector<std::vector<int>>
      borders;               // of each border cycle: the corners that face its edges, in its order
  std::vector<int> interior; // of each vertex: its rank among the interior ones, -1 at the border
  int number_of_interior_vertices = 0;
  // Of each corner that faces an edge of a seam: the one across the seam; -1 elsewhere. Empty without seams.
  std::vector<int> seam;

  int number_of_vertices() const { return static_cast<int>(points.size()); }
  int number_of_corners() const { return static_cast<int>(vertex.size()); }
  int number_of_triangles() const { return number_of_corners() / 3; }
  int number_of_holes() const { return borders.empty() ? 0 : static_cast<int>(borders.size()) - 1; }
  const std::vector<int>& hole(int k) const { return borders[k + 1]; }

  // Rotates about the vertex of `c` into the neighbouring triangle, across the edge to the next corner's
  // vertex: clockwise, so that one gets around a border vertex from the border edge that enters it to the one that
  // leaves it. Returns -1 behind the last triangle.
  int rotate(int c) const
  {
    const int across = opposite[previous_corner(c)];
    return across < 0 ? -1 : previous_corner(across);
  }

  int edge_source(int c) const { return vertex[next_corner(c)]; }
  int edge_target(int c) const { return vertex[previous_corner(c)]; }
};

// The length of the edge that a corner faces, divided by the scale
inline double edge_length(const Corner_table& table, int c)
{
  return std::sqrt(
      CGAL::squared_distance(table.points[table.edge_source(c)], table.points[table.edge_target(c)]));
}

// The vertices of each border cycle, in its order
typedef std::vector<std::vector<int>> Border_cycles;

inline Border_cycles border_cycles(const Corner_table& table)
{
  Border_cycles cycles;
  for(const std::vector<int>& border : table.borders) {
    cycles.emplace_back();
    for(int c : border)
      cycles.back().push_back(table.edge_source(c));
  }
  return cycles;
}

// The matrix of Eq. 16 has at most 14 numbers for each triangle, which are counted with `int`: of `t` triangles at most
// t / 2 vertices and 3 t / 2 edges are interior, each vertex has a block of four numbers, and each edge two of them.
inline constexpr int largest_number_of_triangles = (std::numeric_limits<int>::max)() / 14;

// The power of two next to a number, or 1 if it is zero or not finite
inline double power_of_two(double number)
{
  return number > 0 && std::isfinite(number) ? std::ldexp(1., std::ilogb(number)) : 1.;
}

// Divides the points, which have none yet, by `scale`.
inline void set_scale(double scale, Corner_table& table)
{
  table.scale = scale;
  for(Corner_table::Point_3& p : table.points)
    p = Corner_table::Point_3(p.x() / scale, p.y() / scale, p.z() / scale);
}

// The corner that faces the border edge that follows the one faced by `c`.
inline int next_on_border(const Corner_table& table, int c)
{
  int corner = previous_corner(c);
  for(int next = table.rotate(corner); next >= 0; next = table.rotate(corner))
    corner = next;
  return previous_corner(corner);
}

// Visits all corners at the vertex of a corner, clockwise; at a border vertex from the first one.
template <typename Visit>
void for_corners_around(const Corner_table& table, int corner, const Visit& visit)
{
  int first = corner;
  while(table.opposite[next_corner(first)] >= 0) {
    first = next_corner(table.opposite[next_corner(first)]);
    if(first == corner)
      break;
  }
  visit(first);
  for(int c = table.rotate(first); c >= 0 && c != first; c = table.rotate(c))
    visit(c);
}

// The same corners
inline std::vector<int> corners_around(const Corner_table& table, int corner)
{
  std::vector<int> corners;
  for_corners_around(table, corner, [&](int c) { corners.push_back(c); });
  return corners;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_CORNER_TABLE_H
