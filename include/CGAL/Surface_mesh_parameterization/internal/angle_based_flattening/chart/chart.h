// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The corner table that all stages work on, with its borders, seams and constraint nodes. It is independent of the
// caller's mesh. Made by `read_chart.h` and `read_surface.h`. A node has the equations that the paper has for each
// interior vertex (Eqs. 3 and 4).

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Simple_cartesian.h>

#include <CGAL/number_type_config.h>

#include <cstddef>
#include <cmath>
#include <limits>
#include <vector>

// Functions of flat arrays that the compiled library contains
#ifdef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#define CGAL_ANGLE_BASED_FLATTENING_INLINE
#else
#define CGAL_ANGLE_BASED_FLATTENING_INLINE inline
#endif

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

inline constexpr double pi = CGAL_PI;

// A vertex with equations of the planar angles, or several vertices whose equations are added up: one for the sum of
// the angles (Eq. 3), one for the lengths of the edges around (Eq. 4). A missing equation has the multiplier 0.
struct Constraint_node
{
  double angle_sum = 2 * pi; // 0 if there is none; target angles have this sum even without the equation
  bool has_planarity = true;
  bool has_reconstruction = true;

  bool is_complete() const { return has_planarity && has_reconstruction; }
};

// A triangle that a loop through seams crosses: the corners that face the edges where it enters and leaves the triangle
struct Loop_crossing
{
  int in, out;
  int loop; // number

  int triangle() const { return in / 3; }
};

// A connected triangulated surface with border, as a corner table: all that the stages after `read_chart()` know of a
// mesh. Corner `c` faces the edge from `vertex[next_corner(c)]` to `vertex[previous_corner(c)]`.
struct Chart
{
  typedef CGAL::Simple_cartesian<double> Kernel; // the certificate takes exact predicates
  typedef Kernel::Point_2 Point_2;
  typedef Kernel::Point_3 Point_3;

  std::vector<Point_3> points; // of each vertex, divided by `scale`
  double scale = 1;            // a power of two, so that squares neither overflow nor vanish
  std::vector<int> vertex;     // of each corner
  std::vector<int> opposite;   // of each corner: the one that faces the same edge, -1 at the border
  std::vector<double> weight;  // of each triangle in the energy; empty if all are 1
  std::vector<double> targets; // of each corner, unless they are the angles of the surface
  // Prescribed sums of the planar angles at vertices of the outer border; NaN at others; empty if there are none.
  std::vector<double> angle_sums;
  std::vector<std::vector<int>>
      borders;               // of each border cycle: the corners that face its edges, in its order
  std::vector<int> interior; // of each vertex: its rank among the interior ones, -1 at the border
  int number_of_interior_vertices = 0;
  // Of each corner that faces an edge of a seam: the one across the seam; -1 elsewhere. Empty without seams.
  std::vector<int> seam;
  bool has_equal_seams = false; // both sides of a seam get the same lengths
  // With equal seams, for vertices of the outer border: the prescribed sum of all planar angles at the vertex of the
  // surface before the cut. It is NaN if nothing is prescribed, and infinite if the sum is free. Seam vertices with NaN
  // get 2 pi.
  std::vector<double> surface_sums;
  // Loops through seams, along which lengths must return to their first value; sorted by triangles. Empty without equal
  // seams.
  std::vector<Loop_crossing> crossings;
  int number_of_loops = 0;
  std::vector<int> node; // of each vertex: the one with its equations, or -1
  // In this order:
  // - one for each interior vertex
  // - with equal seams, one for each place on the outer border (see `Seam_places`) that has equations, then one for
  //   each loop
  // - without them, one for each vertex of the outer border with a prescribed angle
  // - one for each vertex of a hole, in the order of `borders`
  std::vector<Constraint_node> nodes;
  int number_of_bound_nodes = 0; // those of the holes, of whose equations only four sums hold

  int number_of_vertices() const { return static_cast<int>(points.size()); }
  int number_of_corners() const { return static_cast<int>(vertex.size()); }
  int number_of_triangles() const { return number_of_corners() / 3; }
  int number_of_nodes() const { return static_cast<int>(nodes.size()); }
  int number_of_free_nodes() const { return number_of_nodes() - number_of_bound_nodes; }
  int number_of_holes() const { return borders.empty() ? 0 : static_cast<int>(borders.size()) - 1; }
  const std::vector<int>& hole(int k) const { return borders[k + 1]; }
  int node_of_corner(int c) const { return node[vertex[c]]; }
  int node_of_loop(int loop) const { return number_of_free_nodes() - number_of_loops + loop; }
  bool has_prescribed_border() const { return !angle_sums.empty(); }
  bool has_prescribed_angles() const { return has_prescribed_border() || !surface_sums.empty(); }
  bool has_border_nodes() const { return has_prescribed_border() || has_equal_seams; }

  // Nothing is prescribed for the vertices of filled holes.
  bool is_angle_prescribed(int v) const
  {
    return v < static_cast<int>(angle_sums.size()) && !std::isnan(angle_sums[v]);
  }

  double weight_of_triangle(int t) const { return weight.empty() ? 1 : weight[t]; }

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
inline double edge_length(const Chart& chart, int c)
{
  return std::sqrt(
      CGAL::squared_distance(chart.points[chart.edge_source(c)], chart.points[chart.edge_target(c)]));
}

// The vertices of each border cycle, in its order
typedef std::vector<std::vector<int>> Border_cycles;

inline Border_cycles border_cycles(const Chart& chart)
{
  Border_cycles cycles;
  for(const std::vector<int>& border : chart.borders) {
    cycles.emplace_back();
    for(int c : border)
      cycles.back().push_back(chart.edge_source(c));
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

// The corner that faces the border edge that follows the one faced by `c`.
inline int next_on_border(const Chart& chart, int c)
{
  int corner = previous_corner(c);
  for(int next = chart.rotate(corner); next >= 0; next = chart.rotate(corner))
    corner = next;
  return previous_corner(corner);
}

// All corners at the vertex of a corner, clockwise; at a border vertex from the first one
inline std::vector<int> corners_around(const Chart& chart, int corner)
{
  int first = corner;
  while(chart.opposite[next_corner(first)] >= 0) {
    first = next_corner(chart.opposite[next_corner(first)]);
    if(first == corner)
      break;
  }
  std::vector<int> corners{first};
  for(int c = chart.rotate(first); c >= 0 && c != first; c = chart.rotate(c))
    corners.push_back(c);
  return corners;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_CHART_H
