// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of `area_energy.h` around a single vertex, with derivatives by the position of that vertex.
// `flatten_injectively.h` relaxes vertex by vertex with it, where a chart is too large for `injective_descent.h`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_STAR_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_STAR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/area_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The triangles around one vertex, as for `MIPS_star`, with their areas: they tell where to move the vertex to lower
// the energy of `Area_energy`.
struct Area_star : Planar_star_base
{
  // A triangle (v, p, q), counterclockwise, with the dot products of the edges at its corners on the surface
  struct Triangle
  {
    Planar_point p, q;
    double dot_v, dot_p, dot_q;
    double weight;       // of its energy
    double inverse_area; // of twice its area on the surface
  };

  class Energy;

  double theta;
  std::vector<Triangle> triangles; // clockwise

  explicit Area_star(double area_weight) : theta(area_weight) {}

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    triangles.clear();
    gather_surface_ring(mesh, uv, v, [&](int c, int p, int q, const Surface_edges& e) {
      const double twice_area = (std::max)(e.twice_area(), 1e-6 * e.sum_of_squares() + 1e-300);
      triangles.push_back({uv[p], uv[q], e.dot_v(), e.dot_p(), e.dot_q(),
                           mesh.chart().weight_of_triangle(c / 3), 1 / twice_area});
    });
  }

  // What the barrier at the vertex is multiplied by: the mean energy of an undistorted triangle
  double barrier_weight() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += 2 * t.weight / t.inverse_area;
    return sum / static_cast<double>(triangles.size());
  }
};

// The energy as a function of the position of the vertex, times four, with derivatives
class Area_star::Energy
{
public:
  double value = 0;
  Planar_point gradient = Planar_point::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();

  Energy(const Area_star& star, const Planar_point& x, bool with_derivatives)
  {
    for(const Triangle& t : star.triangles) {
      const Planar_point xp = x - t.p, xq = x - t.q, pq = t.q - t.p;
      const double twice_area = cross(xp, xq);
      if(!(twice_area > star.least_area)) {
        value = (std::numeric_limits<double>::infinity)();
        return;
      }
      const double inverse = 1 / twice_area;
      const Area_term area(twice_area * t.inverse_area);
      const double factor = t.weight * std::exp(star.theta * area.value);
      const double ratio =
          (t.dot_q * xp.squaredNorm() + t.dot_p * xq.squaredNorm() + t.dot_v * pq.squaredNorm()) * inverse;
      value += factor * ratio;
      if(!with_derivatives)
        continue;
      const Planar_point area_gradient = Planar_point(-pq.y(), pq.x()) * inverse; // of its logarithm
      const Planar_point ratio_gradient = 2 * inverse * (t.dot_q * xp + t.dot_p * xq) - ratio * area_gradient;
      const double slope = star.theta * area.first_derivative;
      gradient += factor * (ratio_gradient + ratio * slope * area_gradient);
      const Eigen::Matrix2d mixed = ratio_gradient * area_gradient.transpose();
      const double curvature = ratio * (star.theta * area.second_derivative + slope * slope - slope);
      hessian += factor * ((slope - 1) * (mixed + mixed.transpose()) +
                           curvature * area_gradient * area_gradient.transpose());
      hessian.diagonal().array() += factor * 2 * inverse * (t.dot_p + t.dot_q);
    }
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_STAR_H
