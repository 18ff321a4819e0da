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
#include <utility>
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

// By what the surface's angles at each node are multiplied, given their sum: around every interior vertex so that they
// have the sum 2 pi that the plane demands, and around any other node its sum. At the vertices of holes they are kept.
inline std::vector<double> target_factors(const Chart& chart, std::vector<double> sum)
{
  for(int i = 0; i < static_cast<int>(sum.size()); ++i) {
    const double wanted = chart.nodes[i].angle_sum;
    sum[i] = i < chart.number_of_free_nodes() && wanted > 0 && sum[i] > 0 ? wanted / sum[i] : 1;
  }
  return sum;
}

// The optimal angle beta of Eq. 1 at corner `c`, where the surface has the angle `angle`
inline double target_angle(const Chart& chart, const std::vector<double>& factors, int c, double angle)
{
  const int i = chart.node_of_corner(c);
  return std::clamp(i < 0 ? angle : angle * factors[i], least_target_angle, pi - least_target_angle);
}

// The optimal angles of all corners
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
  const std::vector<double> factors = target_factors(chart, std::move(sum));
  parallel_for_blocks(chart.number_of_corners(), [&](int begin, int end) {
    for(int c = begin; c < end; ++c)
      beta[c] = target_angle(chart, factors, c, beta[c]);
  });
  return beta;
}

// The same angles one at a time, for a sixth of the memory
class Target_angles
{
public:
  explicit Target_angles(const Chart& chart) : m_chart(chart)
  {
    if(!chart.targets.empty())
      return;
    const int corners = chart.number_of_corners(), batch = 64 * block_size;
    std::vector<double> angle((std::min)(corners, batch)), sum(chart.nodes.size(), 0.);
    for(int first = 0, size; first < corners; first += size) {
      size = (std::min)(batch, corners - first);
      parallel_for_blocks(size, [&](int begin, int end) {
        for(int i = begin; i < end; ++i)
          angle[i] = surface_angle(chart, first + i);
      });
      for(int i = 0; i < size; ++i)
        if(const int node = chart.node_of_corner(first + i); node >= 0)
          sum[node] += angle[i];
    }
    m_factors = target_factors(chart, std::move(sum));
  }

  // At corner `c`, where the surface has the angle `angle`
  double operator()(int c, double angle) const
  {
    return m_chart.targets.empty() ? target_angle(m_chart, m_factors, c, angle) : m_chart.targets[c];
  }

private:
  const Chart& m_chart;
  std::vector<double> m_factors; // of each node
};

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
