// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Target angles of a chart: the surface's own, scaled around each node to the sum that the plane demands (the beta of
// Eq. 1). The direct method, `measure_chart.h`, the layout and the costs of collapses use them.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_TARGET_ANGLES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_TARGET_ANGLES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Target angles stay this far from 0 and pi, so that relative distortion is defined on degenerate triangles.
inline constexpr double least_target_angle = 1e-3;

// The angle at corner `c` of the surface. An arc tangent is accurate for every shape of triangle.
inline double surface_angle(const Chart& chart, int c)
{
  const Chart::Point_3& p = chart.points[chart.vertex[c]];
  const auto a = chart.points[chart.vertex[next_corner(c)]] - p;
  const auto b = chart.points[chart.vertex[previous_corner(c)]] - p;
  return std::atan2(std::sqrt(CGAL::cross_product(a, b).squared_length()), a * b);
}

// The optimal angles beta of Eq. 1, of each corner: the surface's own angles, scaled around every interior vertex to
// the sum 2 pi that the plane demands, and around any other node to its sum. At the vertices of holes they are the
// surface's.
inline std::vector<double> target_angles(const Chart& chart)
{
  if(!chart.targets.empty())
    return chart.targets;
  std::vector<double> beta(chart.vertex.size());
  parallel_for_blocks(chart.number_of_corners(), [&](int begin, int end) {
    for(int c = begin; c < end; ++c)
      beta[c] = surface_angle(chart, c);
  });
  std::vector<double> sum(chart.nodes.size(), 0.);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(const int i = chart.node_of_corner(c); i >= 0)
      sum[i] += beta[c];
  parallel_for_blocks(chart.number_of_corners(), [&](int begin, int end) {
    for(int c = begin; c < end; ++c) {
      const int i = chart.node_of_corner(c);
      if(i >= 0 && i < chart.number_of_free_nodes() && chart.nodes[i].angle_sum > 0 && sum[i] > 0)
        beta[c] *= chart.nodes[i].angle_sum / sum[i];
      beta[c] = (std::min)((std::max)(beta[c], least_target_angle), pi - least_target_angle);
    }
  });
  return beta;
}

// Angles near the targets whose sum is pi in every triangle (Eq. 2): where the solver starts.
inline std::vector<double> starting_angles(const std::vector<double>& beta)
{
  std::vector<double> alpha(beta.size());
  for(std::size_t c = 0; c < beta.size(); c += 3) {
    const double sum = beta[c] + beta[c + 1] + beta[c + 2];
    for(std::size_t k = c; k < c + 3; ++k)
      alpha[k] = beta[k] * (pi / sum);
  }
  return alpha;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_TARGET_ANGLES_H
