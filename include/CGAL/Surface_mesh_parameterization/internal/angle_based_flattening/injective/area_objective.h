// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of `area_energy.h` of a whole map, triangle by triangle, as `Injective_descent` asks for it.
// `flatten_injectively.h` minimizes it on coarse charts, where Newton's method on all vertices at once is affordable.
//
// The energy of angles (Eq. 1) of a whole map, as a function of positions instead of angles, with derivatives triangle
// by triangle. `flatten_injectively.h` polishes with it: `Injective_descent` then nears the optimum of the direct
// method without any overlap.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_OBJECTIVE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_OBJECTIVE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/area_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/definite_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/injective_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/planar_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

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

// The energy of `Area_energy` of a whole map: what `Injective_descent` minimizes on coarse charts.
class Area_objective
{
public:
  Area_objective(const Chart& chart, double theta) : m_chart(chart), m_theta(theta)
  {
    double area = 0;
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      area += Flat_triangle(chart, t, 0).area;
    const double least_area = 1e-9 * area / chart.number_of_triangles();
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      m_triangles.emplace_back(chart, t, least_area);
  }

  double triangle_energy(int t, const std::array<Planar_point, 3>& x) const
  {
    return m_chart.weight_of_triangle(t) * Area_energy::value(m_triangles[t], x, m_theta);
  }

  Triangle_derivatives triangle_derivatives(int t, const std::array<Planar_point, 3>& x) const
  {
    const Area_energy energy(m_triangles[t], x, m_theta);
    const double weight = m_chart.weight_of_triangle(t);
    return {weight * energy.gradient(), weight * energy.projected_hessian()};
  }

  // The energy of an undistorted triangle. It also weighs the barrier between parts of the border.
  double least_energy(int t) const { return triangle_weight(t); }
  double triangle_weight(int t) const { return m_chart.weight_of_triangle(t) * m_triangles[t].area; }

private:
  const Chart& m_chart;
  double m_theta;
  std::vector<Flat_triangle> m_triangles;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_OBJECTIVE_H
