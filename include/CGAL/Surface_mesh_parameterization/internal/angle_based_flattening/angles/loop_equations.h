// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Eq. 4 along loops through seams, so that both sides of a seam also get equal lengths around handles. `constraints.h`
// adds their residuals, and `newton_system.h` their rows and columns to Eq. 16.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_LOOP_EQUATIONS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_LOOP_EQUATIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_angle_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/reduced_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/triangle_assembly.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Along a loop through seams, each triangle changes the length from the edge where the loop enters to the edge where it
// leaves. Back at the first edge, the length must be the same:
//   sum ln sin alpha_out - sum ln sin alpha_in = 0
// That is Eq. 4 for the triangles of a loop instead of those around a vertex.
inline void add_loop_residuals(const Chart& chart, const std::vector<double>& alpha,
                               Eigen::VectorXd& residual)
{
  const auto log_sine = [&](int c) { return std::log(std::sin(alpha[c])); };
  for(const Loop_crossing& crossing : chart.crossings)
    residual[2 * chart.node_of_loop(crossing.loop) + 1] += log_sine(crossing.out) - log_sine(crossing.in);
}

// The largest difference of the logarithms of the lengths of both sides of a seam edge. The residuals of vertices and
// loops add up along a seam.
inline double largest_seam_difference(const Chart& chart, const std::vector<double>& alpha)
{
  if(!chart.equal_seams)
    return 0;
  const std::vector<int>& border = chart.borders.front();
  const Border_walk walk = walk_along_border(chart, alpha, border);
  std::vector<double> log_length(chart.vertex.size(), std::numeric_limits<double>::quiet_NaN());
  for(std::size_t i = 0; i < border.size(); ++i)
    log_length[border[i]] = walk[i].log_length;
  double largest = 0;
  for(int c : border)
    if(const int across = chart.seam[c]; across > c && !std::isnan(log_length[across]))
      largest = (std::max)(largest, std::abs(log_length[c] - log_length[across]));
  return largest;
}

// The loops through the triangles of a chart
class Loop_equations
{
  typedef Small_matrix<1, 2> Plane_row;
  typedef std::vector<Loop_crossing>::const_iterator Iterator;

public:
  explicit Loop_equations(const Chart& chart) : m_chart(chart) {}

  // The nodes of the loops through each triangle that has some
  std::vector<Extra_unknown> nodes() const
  {
    std::vector<Extra_unknown> result;
    for(const Loop_crossing& crossing : m_chart.crossings)
      result.push_back({crossing.triangle(), m_chart.node_of_loop(crossing.loop)});
    return result;
  }

  // The sum of the second derivatives with respect to the angle at corner `c`, times their multipliers
  double curvature(const Eigen::VectorXd& multipliers, int c, double cotangent) const
  {
    double sum = 0;
    for_each_crossing(c / 3, [&](const Loop_crossing& crossing) {
      sum += multiplier(multipliers, crossing) * ((c == crossing.out) - (c == crossing.in));
    });
    return -sum * (1 + cotangent * cotangent);
  }

  // The gradient of the loops times their multipliers, in the plane of the steps that keep the sum of a triangle's
  // angles
  Vector_2 gradient(int t, const Vector_3& cotangents, const Eigen::VectorXd& multipliers) const
  {
    Vector_2 sum = Vector_2::zero();
    for_each_crossing(t, [&](const Loop_crossing& crossing) {
      sum += multiplier(multipliers, crossing) * transposed(row(crossing, cotangents));
    });
    return sum;
  }

  // Adds the rows and columns of the loops to the matrix and the right-hand side of Eq. 16. `local(t)` returns the
  // cotangents of a triangle, the inverse of its reduced Hessian and its force, `jacobian(t)` the rows of its vertices.
  template <typename Local, typename Jacobian>
  void assemble(const Local& local, const Jacobian& jacobian, Triangle_assembly<2>& assembly,
                Eigen::VectorXd& right_hand_side) const
  {
    for(const Loop_crossing& crossing : m_chart.crossings) {
      const int t = crossing.triangle(), j = m_chart.node_of_loop(crossing.loop);
      const auto& of_triangle = local(t);
      const auto rows = jacobian(t);
      const Vector_2 column = of_triangle.inverse * transposed(row(crossing, of_triangle.cotangents));
      right_hand_side[2 * j + 1] += (transposed(column) * of_triangle.force)[0];
      for(int k = 0; k < 3; ++k)
        if(const int i = m_chart.node_of_corner(3 * t + k); i >= 0) {
          const Vector_2 coupling = rows_of<2>(rows, 2 * k) * column;
          for(int l = 0; l < 2; ++l) {
            assembly.block(i, j)(l, 1) += coupling[l];
            assembly.block(j, i)(1, l) += coupling[l];
          }
        }
      for_each_crossing(t, [&](const Loop_crossing& other) {
        assembly.block(m_chart.node_of_loop(other.loop), j)(1, 1) +=
            (row(other, of_triangle.cotangents) * column)[0];
      });
    }
  }

private:
  double multiplier(const Eigen::VectorXd& multipliers, const Loop_crossing& crossing) const
  {
    return multipliers[2 * m_chart.node_of_loop(crossing.loop) + 1];
  }

  // A loop's derivatives by the angles of a triangle, in the plane of steps
  static Plane_row row(const Loop_crossing& crossing, const Vector_3& cotangents)
  {
    const Sum_preserving_steps& basis = basis_of_sum_preserving_steps();
    const int in = crossing.in % 3, out = crossing.out % 3;
    return cotangents[out] * rows_of<1>(basis, out) - cotangents[in] * rows_of<1>(basis, in);
  }

  template <typename Visitor>
  void for_each_crossing(int t, const Visitor& visit) const
  {
    const std::vector<Loop_crossing>& all = m_chart.crossings;
    for(Iterator i = std::lower_bound(
            all.begin(), all.end(), t,
            [](const Loop_crossing&crossing, int triangle) { return crossing.triangle() < triangle; });
        i != all.end() && i->triangle() == t; ++i)
      visit(*i);
  }

  const Chart& m_chart;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_LOOP_EQUATIONS_H
