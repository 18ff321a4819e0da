// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What `Injective_descent` minimizes: an energy of `triangle_energies.h`, triangle by triangle of a whole map.
// `flatten_injectively.h` minimizes that of areas on coarse charts, where Newton's method on all vertices at once is
// affordable, and polishes with that of angles, which nears the optimum of the direct method without any overlap.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_OBJECTIVES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_OBJECTIVES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_differential.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_energies.h>

#include <array>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The energy of the direct method (Eq. 1), as a function of positions instead of angles
class Angle_objective
{
public:
  // `beta` are the target angles of all corners.
  Angle_objective(const Chart& chart, const std::vector<double>& beta, const Angle_energy& energy)
      : m_chart(chart), m_beta(beta), m_energy(energy)
  {}

  double triangle_energy(int t, const Planar_triangle& x) const
  {
    return m_chart.weight_of_triangle(t) * m_energy.value(planar_angles(x), targets(t));
  }

  Triangle_derivatives triangle_derivatives(int t, const Planar_triangle& x) const
  {
    return angle_derivatives(m_energy, m_chart.weight_of_triangle(t), targets(t), x);
  }

  double least_energy(int) const { return 0; }

  // The weight of the barrier between parts of the border. A larger one keeps them farther apart.
  double triangle_weight(int t) const { return 0.01 * m_chart.weight_of_triangle(t); }

private:
  std::array<double, 3> targets(int t) const { return {m_beta[3 * t], m_beta[3 * t + 1], m_beta[3 * t + 2]}; }

  const Chart& m_chart;
  const std::vector<double>& m_beta;
  Angle_energy m_energy;
};

// `area_energy()`
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

  double triangle_energy(int t, const Planar_triangle& x) const
  {
    return m_chart.weight_of_triangle(t) * area_energy(m_theta, m_triangles[t], x);
  }

  Triangle_derivatives triangle_derivatives(int t, const Planar_triangle& x) const
  {
    return area_derivatives(m_theta, m_chart.weight_of_triangle(t), m_triangles[t], x);
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

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_OBJECTIVES_H
