// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The move of one vertex that makes its star more similar to the surface: the relaxation of Section 5.2, with the
// energy MIPS. `relaxation.h` and `border_keeper.h` call it. The paper smooths harmonically instead, which lets stretch
// grow.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAX_VERTEX_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAX_VERTEX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The triangles around one vertex, in the plane and in space. They tell where to move the vertex so that both are as
// similar as possible.
struct MIPS_star : Planar_star_base
{
  // A triangle (v, p, q), counterclockwise. Twice its area on the surface times the cotangent of an angle is the dot
  // product of the edges there: neither roots nor divisions are needed.
  struct Triangle
  {
    Planar_point p, q;
    double dot_v, dot_p, dot_q;
  };

  class Energy;

  std::vector<Triangle> triangles; // clockwise

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    triangles.clear();
    gather_surface_ring(mesh, uv, v, [&](int c, int p, int q, const Surface_edges& e) {
      const double weight = mesh.chart().weight_of_triangle(c / 3);
      triangles.push_back({uv[p], uv[q], weight * e.dot_v(), weight * e.dot_p(), weight * e.dot_q()});
    });
  }

  // What a barrier at the vertex is multiplied by: the mean energy of an undistorted triangle. (The products of two
  // cotangents in a triangle add up to 1.)
  double barrier_weight() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += 2 * std::sqrt((std::max)(t.dot_v * t.dot_p + t.dot_p * t.dot_q + t.dot_q * t.dot_v, 0.));
    return sum / static_cast<double>(triangles.size());
  }
};

// The energy of a star as a function of the position of its vertex, with derivatives. It sums, over the triangles,
// four times the area on the surface times the ratio of Dirichlet energy to planar area. The ratio is one for similar
// triangles, and grows without bound as a triangle collapses. The energy is infinite where the star is not valid.
class MIPS_star::Energy
{
public:
  double value = 0;
  Planar_point gradient = Planar_point::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();

  Energy(const MIPS_star& star, const Planar_point& x, bool with_derivatives)
  {
    for(const Triangle& t : star.triangles) {
      const Planar_point xp = x - t.p, xq = x - t.q, pq = t.q - t.p;
      const double twice_area = cross(xp, xq);
      if(!(twice_area > star.least_area)) {
        value = (std::numeric_limits<double>::infinity)();
        return;
      }
      const double inverse = 1 / twice_area;
      const double ratio =
          (t.dot_q * xp.squaredNorm() + t.dot_p * xq.squaredNorm() + t.dot_v * pq.squaredNorm()) * inverse;
      value += ratio;
      if(with_derivatives)
        add_derivatives(t, xp, xq, Planar_point(-pq.y(), pq.x()), ratio, inverse);
    }
  }

private:
  void add_derivatives(const Triangle& t, const Planar_point& xp, const Planar_point& xq,
                       const Planar_point& area_gradient, double ratio, double inverse)
  {
    const Planar_point dirichlet_gradient = 2 * (t.dot_q * xp + t.dot_p * xq);
    const Planar_point ratio_gradient = (dirichlet_gradient - ratio * area_gradient) * inverse;
    gradient += ratio_gradient;
    const Planar_point mixed = (2 * inverse) * area_gradient;
    const double squared_edge = 2 * inverse * (t.dot_p + t.dot_q);
    const double off_diagonal = ratio_gradient.x() * mixed.y() + ratio_gradient.y() * mixed.x();
    hessian(0, 0) += squared_edge - ratio_gradient.x() * mixed.x();
    hessian(1, 1) += squared_edge - ratio_gradient.y() * mixed.y();
    hessian(0, 1) -= off_diagonal / 2;
    hessian(1, 0) -= off_diagonal / 2;
  }
};

// A step of Newton's method towards the least energy of a star, or along the gradient where the energy is not convex
template <typename Energy>
Planar_point newton_step(const Energy& here)
{
  const double determinant =
      here.hessian(0, 0) * here.hessian(1, 1) - here.hessian(0, 1) * here.hessian(0, 1);
  if(!(determinant > 0 && here.hessian.trace() > 0))
    return -here.gradient / (here.hessian.cwiseAbs().sum() + (std::numeric_limits<double>::min)());
  return Planar_point(here.hessian(0, 1) * here.gradient.y() - here.hessian(1, 1) * here.gradient.x(),
                      here.hessian(0, 1) * here.gradient.x() - here.hessian(0, 0) * here.gradient.y()) /
         determinant;
}

// Moves a vertex by an over-relaxed Newton step, where `accept` allows it. Returns by which factor the energy
// of its star fell, or 1 if the vertex does not move.
template <typename Star, typename Accept>
double relax_vertex(const Star& star, Planar_point& position, const Accept& accept)
{
  typedef typename Star::Energy Energy;
  const Energy here(star, position, true);
  if(!std::isfinite(here.value))
    return 1;
  Planar_point step = star.over_relaxation * newton_step(here);
  for(int halvings = 0; halvings < 5; ++halvings, step /= 2) {
    const Planar_point next = position + step;
    const double value = Energy(star, next, false).value;
    if(value < here.value && accept(next)) {
      position = next;
      return value / here.value;
    }
  }
  return 1;
}

// The same by several steps where triangles are nearly degenerate: each step makes such a triangle higher by a third
// only.
template <typename Star, typename Accept>
double relax_vertex_repeatedly(const Star& star, Planar_point& position, const Accept& accept)
{
  const int most_steps = 50;
  double fall = relax_vertex(star, position, accept), whole = fall;
  for(int step = 1; step < most_steps && fall < 0.7; ++step)
    whole *= fall = relax_vertex(star, position, accept);
  return whole;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAX_VERTEX_H
