// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of angles (Eq. 1) around one vertex as a function of its position, with gradient and Gauss-Newton Hessian.
// `angle_descent.h` moves one vertex after the other by it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_ANGLE_STAR_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_ANGLE_STAR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>

#include <Eigen/Core>

#include <array>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The triangles around one vertex in the plane, with the target angles of all their corners. They tell where to move
// the vertex to minimize the energy of the direct method.
struct Angle_star : Planar_star_base
{
  struct Triangle
  {
    Planar_point p, q;
    std::array<double, 3> beta; // of the corners at v, p, q
    double weight;
  };

  class Energy;

  std::vector<Triangle> triangles; // clockwise
  const std::vector<double>& beta; // target angle of each corner
  Angle_energy energy;

  Angle_star(const std::vector<double>& target_angles, const Angle_energy& angle_energy)
      : beta(target_angles), energy(angle_energy)
  {}

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    triangles.clear();
    gather_ring(mesh, uv, v, [&](int c, int p, int q) {
      triangles.push_back({uv[p],
                           uv[q],
                           {beta[c], beta[next_corner(c)], beta[previous_corner(c)]},
                           mesh.chart().weight_of_triangle(c / 3)});
    });
  }

  // What the barrier between parts of the border is multiplied by
  double barrier_weight() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += t.weight;
    return 0.01 * sum / static_cast<double>(triangles.size());
  }
};

// The energy of the angles of a star as a function of the position of its vertex. The Hessian is that of
// Gauss-Newton, which is never indefinite. The energy is infinite where the star is not valid.
class Angle_star::Energy
{
public:
  double value = 0;
  Planar_point gradient = Planar_point::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();

  Energy(const Angle_star& star, const Planar_point& x, bool with_derivatives)
  {
    for(const Triangle& t : star.triangles) {
      const Planar_point to_p = t.p - x, to_q = t.q - x, pq = t.q - t.p;
      const double twice_area = cross(to_p, to_q);
      if(!(twice_area > star.least_area)) {
        value = (std::numeric_limits<double>::infinity)();
        return;
      }
      const std::array<double, 3> alpha =
          planar_angles(twice_area, {to_p.dot(to_q), -to_p.dot(pq), to_q.dot(pq)});
      value += t.weight * star.energy.value(alpha, t.beta);
      if(!with_derivatives)
        continue;
      // The angle at p changes if x moves across the edge to p, but not if it moves along the edge.
      const Planar_point along_p = Planar_point(to_p.y(), -to_p.x()) / to_p.squaredNorm();
      const Planar_point along_q = Planar_point(-to_q.y(), to_q.x()) / to_q.squaredNorm();
      add(star.energy, t.weight, alpha[1], t.beta[1], along_p);
      add(star.energy, t.weight, alpha[2], t.beta[2], along_q);
      add(star.energy, t.weight, alpha[0], t.beta[0], -along_p - along_q);
    }
  }

private:
  void add(const Angle_energy& energy, double weight, double alpha, double beta,
           const Planar_point& angle_gradient)
  {
    gradient += weight * energy.first_derivative(alpha, beta) * angle_gradient;
    hessian += weight * energy.second_derivative(alpha, beta) * angle_gradient * angle_gradient.transpose();
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_ANGLE_STAR_H
