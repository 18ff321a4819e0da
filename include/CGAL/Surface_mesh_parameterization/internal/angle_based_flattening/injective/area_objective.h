// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of `area_energy.h` of a whole map, triangle by triangle, as `Injective_descent` asks for it.
// `flatten_injectively.h` minimizes it on coarse charts, where Newton's method on all vertices at once is affordable.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_OBJECTIVE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_OBJECTIVE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/area_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/definite_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/injective_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/planar_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <array>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

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
