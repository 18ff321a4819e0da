// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From angles to coordinates if the constraints hold: a walk along the border by the sine rule, then one Laplace
// equation for the interior. Turns that are prescribed stay exact, and lengths alone close the polygon.
// `lay_out_angles.h` prefers it to the least squares of Eqs. 19 to 21, which spread errors over the whole chart.
// `predict_scale.h` and `seams/log_scale.h` share its cotangent Laplacian.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_EXACT_LAYOUT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_EXACT_LAYOUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_angle_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/hole_equations.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/newton_equation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/triangle_assembly.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Walks along the outer border, and turns by exactly the prescribed angles, so that sides are straight for any
// tolerance. The other vertices share the rest of the full turn.
inline Border_walk walk_along_prescribed_border(const Chart& chart, const std::vector<double>& alpha)
{
  const std::vector<int>& border = chart.borders.front();
  Border_walk walk = walk_along_border(chart, alpha, border);
  std::vector<double> turns;
  double missing = 2 * pi;
  int others = 0;
  for(std::size_t i = 0; i < border.size(); ++i) {
    const int v = chart.edge_target(border[i]);
    const bool is_prescribed = chart.is_angle_prescribed(v);
    turns.push_back(is_prescribed ? pi - chart.angle_sums[v] : walk[i + 1].direction - walk[i].direction);
    missing -= turns.back();
    others += !is_prescribed;
  }
  for(std::size_t i = 0; i < border.size(); ++i) {
    const bool is_prescribed = chart.is_angle_prescribed(chart.edge_target(border[i]));
    walk[i + 1].direction = walk[i].direction + turns[i] + (is_prescribed ? 0 : missing / others);
  }
  return walk;
}

// Closes a polygon by changing the lengths of its edges, but not their directions. Relative changes are least in the
// sense of least squares, with the lengths as weights.
inline void close_by_lengths(const Chart::Kernel::Vector_2& gap, std::vector<Chart::Kernel::Vector_2>& edges)
{
  Matrix_2 matrix = Matrix_2::zero();
  for(const Chart::Kernel::Vector_2& edge : edges) {
    const Vector_2 e = {{edge.x(), edge.y()}};
    if(const double length = std::sqrt(e[0] * e[0] + e[1] * e[1]); length > 0)
      for(int j = 0; j < 2; ++j)
        for(int i = 0; i < 2; ++i)
          matrix(i, j) += e[i] * e[j] / length;
  }
  const double factor = 1 / (matrix(0, 0) * matrix(1, 1) - matrix(1, 0) * matrix(0, 1));
  const Matrix_2 inverse = {
      {matrix(1, 1) * factor, -matrix(1, 0) * factor, -matrix(0, 1) * factor, matrix(0, 0) * factor}};
  const Vector_2 multipliers = inverse * Vector_2{{gap.x(), gap.y()}};
  for(Chart::Kernel::Vector_2& edge : edges)
    if(const double length = std::sqrt(edge.squared_length()); length > 0)
      edge = edge * (1 - (multipliers[0] * edge.x() + multipliers[1] * edge.y()) / length);
}

// The next edge of a triangle, counterclockwise, after the one that corner `c` faces
inline Planar_edge next_edge(const Planar_edge& edge, const std::vector<double>& alpha, int c)
{
  return {edge.direction + pi - alpha[previous_corner(c)],
          edge.log_length + std::log(std::sin(alpha[next_corner(c)]) / std::sin(alpha[c]))};
}

// The first edge of each hole, if the first edge of the outer border has direction and log length 0. The angles along
// the shortest way from triangle to triangle determine it. (Other ways differ only as far as the angles violate their
// constraints.)
inline std::vector<Planar_edge> first_edges_of_holes(const Chart& chart, const std::vector<double>& alpha)
{
  std::vector<Planar_edge> edge(chart.vertex.size()); // that each corner faces
  std::vector<int> entry{chart.borders.front().front()};
  std::vector<char> is_found(chart.number_of_triangles(), false);
  is_found[entry.front() / 3] = true;
  for(std::size_t i = 0; i < entry.size(); ++i) {
    for(int c = entry[i]; next_corner(c) != entry[i]; c = next_corner(c))
      edge[next_corner(c)] = next_edge(edge[c], alpha, c);
    for(int c = 3 * (entry[i] / 3), end = c + 3; c < end; ++c)
      if(const int across = chart.opposite[c]; across >= 0 && !is_found[across / 3]) {
        is_found[across / 3] = true;
        edge[across] = {edge[c].direction + pi, edge[c].log_length};
        entry.push_back(across);
      }
  }
  std::vector<Planar_edge> first_edges;
  for(int k = 0; k < chart.number_of_holes(); ++k)
    first_edges.push_back(edge[chart.hole(k).front()]);
  return first_edges;
}

// Planar coordinates of each vertex, and how much closing the borders changed them.
struct Layout
{
  std::vector<Chart::Point_2> uv;
  double closure = 0; // largest gap at the end of a walk along a border, relative to the border's length
  bool is_repeated = false; // whether low precision was not enough for the linear system
};

// The edges along a walk in the plane
struct Planar_edges
{
  std::vector<Chart::Kernel::Vector_2> edges;
  Chart::Kernel::Vector_2 gap = {0, 0}; // between the end of the last one and the start of the first
  double perimeter = 0;

  // In the unit whose logarithm is `log_unit`
  Planar_edges(const Border_walk& walk, double log_unit)
  {
    for(std::size_t i = 0; i + 1 < walk.size(); ++i) {
      const double length = std::exp(walk[i].log_length - log_unit);
      edges.emplace_back(length * std::cos(walk[i].direction), length * std::sin(walk[i].direction));
      gap = gap + edges.back();
      perimeter += std::sqrt(edges.back().squared_length());
    }
  }

  double relative_gap() const { return std::sqrt(gap.squared_length()) / perimeter; }
};

// Sets the coordinates of a border's vertices to those along a walk, relative to the first one, in the unit whose
// logarithm is `log_unit`. Spreads the gap that is left over all edges, and returns it relative to the border's length.
inline double lay_out_border(const Chart& chart, const std::vector<int>& border, const Border_walk& walk,
                             double log_unit, std::vector<Chart::Point_2>& uv)
{
  const Planar_edges planar(walk, log_unit);
  Chart::Point_2 position(0, 0);
  for(std::size_t i = 0; i < border.size(); ++i) {
    uv[chart.edge_source(border[i])] = position;
    position = position + planar.edges[i] -
               planar.gap * (std::sqrt(planar.edges[i].squared_length()) / planar.perimeter);
  }
  return planar.relative_gap();
}

// The same for a border with prescribed angles, which closing the gap does not change
inline double lay_out_prescribed_border(const Chart& chart, const Border_walk& walk, double log_unit,
                                        std::vector<Chart::Point_2>& uv)
{
  const std::vector<int>& border = chart.borders.front();
  Planar_edges planar(walk, log_unit);
  close_by_lengths(planar.gap, planar.edges);
  Chart::Point_2 position(0, 0);
  for(std::size_t i = 0; i < border.size(); ++i) {
    uv[chart.edge_source(border[i])] = position;
    position = position + planar.edges[i];
  }
  return planar.relative_gap();
}

// Lays out the outer border, and each hole with its direction and size, but without its position.
inline void lay_out_borders(const Chart& chart, const std::vector<double>& alpha, Layout& layout)
{
  const std::vector<int>& outer = chart.borders.front();
  const Border_walk walk = chart.has_prescribed_border() ? walk_along_prescribed_border(chart, alpha)
                                                         : walk_along_border(chart, alpha, outer);
  const double longest =
      std::max_element(walk.begin(), walk.end() - 1, [](const Planar_edge& a, const Planar_edge& b) {
        return a.log_length < b.log_length;
      })->log_length;
  layout.closure = chart.has_prescribed_border() ? lay_out_prescribed_border(chart, walk, longest, layout.uv)
                                                 : lay_out_border(chart, outer, walk, longest, layout.uv);
  if(chart.number_of_holes() == 0)
    return;
  const std::vector<Planar_edge> first_edges = first_edges_of_holes(chart, alpha);
  for(int k = 0; k < chart.number_of_holes(); ++k) {
    const std::vector<int>& hole = chart.hole(k);
    Hole_equations equations;
    const Border_walk around =
        walk_around_hole(chart, alpha, hole, hole_edges(chart, hole), equations, first_edges[k]);
    layout.closure = (std::max)(layout.closure, lay_out_border(chart, hole, around, longest, layout.uv));
  }
}

// The unknown translation of each vertex: its own if it is an interior one, that of its hole, or none (-1) at the outer
// border.
inline std::vector<int> unknown_translations(const Chart& chart)
{
  std::vector<int> unknown = chart.interior;
  for(int k = 0; k < chart.number_of_holes(); ++k)
    for(int c : chart.hole(k))
      unknown[chart.edge_source(c)] = chart.number_of_interior_vertices + k;
  return unknown;
}

inline std::vector<double> cotangents(const std::vector<double>& alpha)
{
  std::vector<double> result(alpha.size());
  parallel_for_blocks(static_cast<int>(alpha.size()) / 3, [&](int begin, int end) {
    for(int t = begin; t < end; ++t)
      std::copy_n(cotangents(alpha, t).entry, 3, result.data() + 3 * t);
  });
  return result;
}

// The cotangent Laplacian, with twice the usual weights
inline Triangle_assembly<1> cotangent_laplacian(const Chart& chart, const std::vector<double>& weights,
                                                const std::vector<int>& unknown, int n)
{
  Triangle_assembly<1> laplacian(chart.vertex, unknown, n);
  laplacian.assemble([&](int c) {
    Vector_3 column;
    column[c % 3] = weights[next_corner(c)] + weights[previous_corner(c)];
    column[next_corner(c) % 3] = -weights[previous_corner(c)];
    column[previous_corner(c) % 3] = -weights[next_corner(c)];
    return column;
  });
  return laplacian;
}

// The right-hand sides, of both coordinates: minus the Laplacian of `uv`, where that is known
inline Two_vectors boundary_right_hand_side(const Chart& chart, const std::vector<double>& weights,
                                            const std::vector<int>& unknown, int n,
                                            const std::vector<Chart::Point_2>& uv)
{
  Two_vectors sum = {Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
  for(int c = 0; c < chart.number_of_corners(); ++c) {
    if(chart.interior[chart.vertex[c]] >= 0)
      continue;
    const Chart::Point_2& border = uv[chart.vertex[c]];
    const auto add = [&](int i, double weight) {
      if(i >= 0) {
        sum[0][i] += weight * border.x();
        sum[1][i] += weight * border.y();
      }
    };
    const auto add_edge = [&](int neighbour, int facing) {
      add(unknown[chart.vertex[neighbour]], weights[facing]);
      add(unknown[chart.vertex[c]], -weights[facing]);
    };
    add_edge(next_corner(c), previous_corner(c));
    add_edge(previous_corner(c), next_corner(c));
  }
  return sum;
}

// Sets the coordinates of the interior vertices, and puts the holes into place: the cotangent Laplacian with the planar
// angles' own cotangents vanishes on the planar triangulation that has these angles, so that one solve reproduces it.
// At the vertices of a hole, its natural boundary values do not vanish, but their sum does: they are half the edges of
// the hole, turned by a right angle.
inline bool lay_out_interior(const Chart& chart, const std::vector<double>& alpha,
                             Linear_solver& scalar_solver, Layout& layout)
{
  const int n = chart.number_of_interior_vertices + chart.number_of_holes();
  if(n == 0)
    return true;
  const std::vector<int> unknown = unknown_translations(chart);
  std::vector<double> weights = cotangents(alpha);
  const Triangle_assembly<1> laplacian = cotangent_laplacian(chart, weights, unknown, n);
  const Two_vectors right_hand_sides = boundary_right_hand_side(chart, weights, unknown, n, layout.uv);
  std::vector<double>().swap(weights); // factorization needs the memory
  Two_vectors positions;
  if(!solve_definite(laplacian.matrix(), scalar_solver, right_hand_sides, positions))
    return false;
  layout.is_repeated = scalar_solver.is_repeated();
  for(int w = 0; w < chart.number_of_vertices(); ++w)
    if(const int i = unknown[w]; i >= 0)
      layout.uv[w] = layout.uv[w] + Chart::Kernel::Vector_2(positions[0][i], positions[1][i]);
  return true;
}

// The layout of a chart whose angles fulfil the constraints. `scalar_solver` may know the pattern of the one-rings of
// the interior vertices and the holes. Returns nothing if the linear solver fails.
inline std::optional<Layout> exact_layout(const Chart& chart, const std::vector<double>& alpha,
                                          Linear_solver& scalar_solver)
{
  Layout layout;
  layout.uv.assign(chart.points.size(), Chart::Point_2(0, 0));
  lay_out_borders(chart, alpha, layout);
  if(!lay_out_interior(chart, alpha, scalar_solver, layout))
    return std::nullopt;
  return layout;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_EXACT_LAYOUT_H
