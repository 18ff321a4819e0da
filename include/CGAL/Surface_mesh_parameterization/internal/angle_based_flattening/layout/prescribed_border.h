// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The walk along an outer border with prescribed angles: turns are exactly those prescribed, and lengths alone close
// the polygon. `exact_layout.h` calls it, so that straight sides stay straight although the angles are solved to a
// tolerance only.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PRESCRIBED_BORDER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PRESCRIBED_BORDER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_angle_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/small_matrix.h>

#include <cmath>
#include <cstddef>
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

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PRESCRIBED_BORDER_H
