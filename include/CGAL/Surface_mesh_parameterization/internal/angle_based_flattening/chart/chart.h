// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A chart: its corner table, and what its planar angles must fulfil. It is independent of the caller's mesh. Made by
// `read_chart.h` and `read_surface.h`. A node has the equations that the paper has for each interior vertex (Eqs. 3 and
// 4).

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

inline constexpr double pi = CGAL_PI;

// A vertex with equations of the planar angles, or several vertices whose equations are added up: one for the sum of
// the angles (Eq. 3), one for the lengths of the edges around (Eq. 4). What is not there has the multiplier 0.
struct Constraint_node
{
  double angle_sum = 2 * pi; // 0 if there is none; target angles have it also where the equation is not there
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

// What the planar angles of a chart must fulfil, and how much each triangle matters
struct Angle_constraints
{
  // A vertex with a given position in the plane
  struct Pin
  {
    int vertex;
    Corner_table::Point_2 position;
  };

  std::vector<double> weight;  // of each triangle in the energy; empty if all are 1
  std::vector<double> targets; // of each corner, unless they are the angles of the surface
  // Prescribed sums of the planar angles at vertices of the outer border; NaN at others; empty if there are none.
  std::vector<double> angle_sums;
  bool equal_seams = false; // whether both sides of each seam on the outer border get the same lengths
  // With equal seams, of vertices of the outer border: prescribed sums of all planar angles at the vertex of the
  // surface before the cut. NaN where there is none: such vertices in the middle of a seam have 2 pi. Infinite where
  // the sum is free.
  std::vector<double> surface_sums;
  // Loops through seams, along which lengths must come back to what they were; sorted by triangles. Empty without equal
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
  std::vector<Pin> pins;         // the finished map is moved there

  int number_of_nodes() const { return static_cast<int>(nodes.size()); }
  int number_of_free_nodes() const { return number_of_nodes() - number_of_bound_nodes; }
  int node_of_loop(int loop) const { return number_of_free_nodes() - number_of_loops + loop; }
  bool has_prescribed_border() const { return !angle_sums.empty(); }
  bool has_prescribed_angles() const { return has_prescribed_border() || !surface_sums.empty(); }
  bool has_border_nodes() const { return has_prescribed_border() || equal_seams; }

  // Filled holes have vertices that nobody prescribed anything for.
  bool is_angle_prescribed(int v) const
  {
    return v < static_cast<int>(angle_sums.size()) && !std::isnan(angle_sums[v]);
  }

  double weight_of_triangle(int t) const { return weight.empty() ? 1 : weight[t]; }
};

struct Chart : Corner_table, Angle_constraints
{
  int node_of_corner(int c) const { return node[vertex[c]]; }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_CHART_H
