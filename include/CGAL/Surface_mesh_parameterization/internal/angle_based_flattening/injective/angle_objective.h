// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of angles (Eq. 1) of a whole map, as a function of positions instead of angles, with derivatives triangle
// by triangle. `flatten_injectively.h` polishes with it: `Injective_descent` then nears the optimum of the direct
// method without any overlap.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_ANGLE_OBJECTIVE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_ANGLE_OBJECTIVE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/definite_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The energy of the direct method (Eq. 1) as a function of the positions: what `Injective_descent` minimizes to polish
// a map. The Hessian is that of Gauss and Newton.
class Angle_objective
{
public:
  // `beta` are the target angles of all corners.
  Angle_objective(const Chart& chart, const std::vector<double>& beta, const Angle_energy& energy)
      : m_chart(chart), m_beta(beta), m_energy(energy)
  {}

  double triangle_energy(int t, const std::array<Planar_point, 3>& x) const
  {
    const std::array<double, 3> alpha = angles(x);
    return m_chart.weight_of_triangle(t) *
           m_energy.value(alpha, {m_beta[3 * t], m_beta[3 * t + 1], m_beta[3 * t + 2]});
  }

  Triangle_derivatives triangle_derivatives(int t, const std::array<Planar_point, 3>& x) const
  {
    const std::array<double, 3> alpha = angles(x);
    // How the direction of edge k, from corner k + 1 to k + 2, changes as its end moves
    std::array<Planar_point, 3> turn;
    for(int k = 0; k < 3; ++k) {
      const Planar_point edge = x[(k + 2) % 3] - x[(k + 1) % 3];
      turn[k] = Planar_point(-edge.y(), edge.x()) / edge.squaredNorm();
    }
    Triangle_derivatives result;
    result.gradient.setZero();
    result.hessian.setZero();
    for(int k = 0; k < 3; ++k) {
      const int p = (k + 1) % 3, q = (k + 2) % 3;
      const double beta = m_beta[3 * t + k], weight = m_chart.weight_of_triangle(t);
      Eigen::Matrix<double, 6, 1> slope;
      slope.segment<2>(2 * q) = -turn[p];
      slope.segment<2>(2 * p) = -turn[q];
      slope.segment<2>(2 * k) = turn[p] + turn[q];
      result.gradient += weight * m_energy.first_derivative(alpha[k], beta) * slope;
      result.hessian += weight * m_energy.second_derivative(alpha[k], beta) * slope * slope.transpose();
    }
    return result;
  }

  double least_energy(int) const { return 0; }

  // The weight of the barrier between parts of the border. A larger one keeps them farther apart.
  double triangle_weight(int t) const { return 0.01 * m_chart.weight_of_triangle(t); }

private:
  static std::array<double, 3> angles(const std::array<Planar_point, 3>& x)
  {
    const double twice_area = cross(x[1] - x[0], x[2] - x[0]);
    std::array<double, 3> dots;
    for(int k = 0; k < 3; ++k)
      dots[k] = (x[(k + 1) % 3] - x[k]).dot(x[(k + 2) % 3] - x[k]);
    return planar_angles(twice_area, dots);
  }

  const Chart& m_chart;
  const std::vector<double>& m_beta;
  Angle_energy m_energy;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_ANGLE_OBJECTIVE_H
