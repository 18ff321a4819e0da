// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_EXACT_LAYOUT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_EXACT_LAYOUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/mixed_precision.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/triangle_assembly.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Planar coordinates of each vertex, and by how much they had to be bent.
struct Layout
{
  std::vector<Chart::Point_2> uv;
  double closure = 0;       // gap at the end of the border walk, relative to its length
  bool is_repeated = false; // whether low precision was not enough for the linear system
};

// The directed edges of the planar border, that the angles alone determine up to a similarity: at a vertex the
// border turns by pi less the angles there, and its edges' lengths are related by the sine rule through the fan.
inline std::vector<Chart::Kernel::Vector_2> border_edges(const Chart& chart, const std::vector<double>& alpha,
                                                         const std::vector<int>& border)
{
  std::vector<double> direction(border.size()), log_length(border.size());
  direction[0] = log_length[0] = 0;
  for(std::size_t i = 0; i + 1 < border.size(); ++i) {
    direction[i + 1] = direction[i] + pi;
    log_length[i + 1] = log_length[i];
    for(int c = previous_corner(border[i]); c >= 0; c = chart.rotate(c)) {
      direction[i + 1] -= alpha[c];
      log_length[i + 1] += std::log(std::sin(alpha[previous_corner(c)]) / std::sin(alpha[next_corner(c)]));
    }
  }
  const double longest = *std::max_element(log_length.begin(), log_length.end());
  std::vector<Chart::Kernel::Vector_2> edges;
  for(std::size_t i = 0; i < border.size(); ++i) {
    const double length = std::exp(log_length[i] - longest);
    edges.emplace_back(length * std::cos(direction[i]), length * std::sin(direction[i]));
  }
  return edges;
}

// Sets the coordinates of the border's vertices. The gap that rounding leaves is spread over all edges.
inline void lay_out_border(const Chart& chart, const std::vector<double>& alpha, Layout& layout)
{
  const std::vector<int>& border = chart.borders.front();
  const auto edges = border_edges(chart, alpha, border);
  Chart::Kernel::Vector_2 gap(0, 0);
  double perimeter = 0;
  for(const auto& edge : edges) {
    gap = gap + edge;
    perimeter += std::sqrt(edge.squared_length());
  }
  layout.closure = std::sqrt(gap.squared_length()) / perimeter;
  Chart::Point_2 position(0, 0);
  for(std::size_t i = 0; i < border.size(); ++i) {
    layout.uv[chart.edge_source(border[i])] = position;
    position = position + edges[i] - gap * (std::sqrt(edges[i].squared_length()) / perimeter);
  }
}

inline std::vector<double> cotangents(const std::vector<double>& alpha)
{
  std::vector<double> result(alpha.size());
  parallel_for_blocks(static_cast<int>(alpha.size()) / 3, [&](int begin, int end) {
    for(int t = begin; t < end; ++t)
      Eigen::Map<Eigen::Vector3d>(result.data() + 3 * t) = cotangents(alpha, t);
  });
  return result;
}

// The right-hand sides, of both coordinates: what the border vertices contribute to the Laplacian
inline Two_vectors boundary_right_hand_side(const Chart& chart, const std::vector<double>& weights,
                                            const Layout& layout)
{
  const int n = chart.number_of_interior_vertices;
  Two_vectors sum = {Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
  for(int c = 0; c < chart.number_of_corners(); ++c) {
    if(chart.interior[chart.vertex[c]] >= 0)
      continue;
    const Chart::Point_2& border = layout.uv[chart.vertex[c]];
    const auto add = [&](int neighbour, int facing) {
      if(const int i = chart.interior[chart.vertex[neighbour]]; i >= 0) {
        sum[0][i] += weights[facing] * border.x();
        sum[1][i] += weights[facing] * border.y();
      }
    };
    add(next_corner(c), previous_corner(c));
    add(previous_corner(c), next_corner(c));
  }
  return sum;
}

// Sets the coordinates of the interior vertices: the cotangent Laplacian with the planar angles' own cotangents
// vanishes on the planar triangulation that has these angles, so that one solve reproduces it.
inline bool lay_out_interior(const Chart& chart, const std::vector<double>& alpha,
                             const Linear_solvers& solvers, std::unique_ptr<Linear_solver> scalar_solver,
                             Layout& layout)
{
  const int n = chart.number_of_interior_vertices;
  if(n == 0)
    return true;
  Triangle_assembly<1> laplacian(chart.vertex, chart.interior, n);
  Two_vectors right_hand_sides, positions;
  {
    const std::vector<double> weights = cotangents(alpha);
    laplacian.assemble([&](int c) {
      Eigen::Vector3d column;
      column[c % 3] = weights[next_corner(c)] + weights[previous_corner(c)];
      column[next_corner(c) % 3] = -weights[previous_corner(c)];
      column[previous_corner(c) % 3] = -weights[next_corner(c)];
      return column;
    });
    right_hand_sides = boundary_right_hand_side(chart, weights, layout);
  }
  Definite_system system(solvers, std::move(scalar_solver));
  if(!system.solve(laplacian.matrix(), right_hand_sides, positions))
    return false;
  layout.is_repeated = system.is_repeated();
  for(int w = 0; w < chart.number_of_vertices(); ++w)
    if(const int i = chart.interior[w]; i >= 0)
      layout.uv[w] = Chart::Point_2(positions[0][i], positions[1][i]);
  return true;
}

// The layout of a chart with one border whose angles fulfil the constraints. `scalar_solver` may know the pattern of the
// one-rings of the interior vertices. Returns nothing if the linear solver fails.
inline std::optional<Layout> exact_layout(const Chart& chart, const std::vector<double>& alpha,
                                          const Linear_solvers& solvers,
                                          std::unique_ptr<Linear_solver> scalar_solver)
{
  Layout layout;
  layout.uv.assign(chart.points.size(), Chart::Point_2(0, 0));
  lay_out_border(chart, alpha, layout);
  if(!lay_out_interior(chart, alpha, solvers, std::move(scalar_solver), layout))
    return std::nullopt;
  return layout;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_EXACT_LAYOUT_H
