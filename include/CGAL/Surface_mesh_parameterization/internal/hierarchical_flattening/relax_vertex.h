// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_RELAX_VERTEX_H
#define CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_RELAX_VERTEX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/planar_star.h>

#include <Eigen/Core>

#include <cmath>
#include <limits>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The energy of a star as a function of the place of its vertex, with derivatives: of each triangle the area on the
// surface times the ratio of its Dirichlet energy to its area in the plane. The ratio is one for similar triangles,
// and grows without bound as a triangle collapses.
struct Planar_star::Energy
{
  double value = 0;
  Planar_point gradient = Planar_point::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();

  Energy(const Planar_star& star, const Planar_point& x, bool with_derivatives)
  {
    for(const Triangle& t : star.triangles) {
      const Planar_point xp = x - t.p, xq = x - t.q, pq = t.q - t.p;
      const double area = cross(-xp, -xq) / 2;
      const double dirichlet =
          (t.cot_q * xp.squaredNorm() + t.cot_p * xq.squaredNorm() + t.cot_v * pq.squaredNorm()) / 4;
      const double ratio = dirichlet / area;
      value += t.area * ratio;
      if(!with_derivatives)
        continue;
      const Planar_point area_gradient = Planar_point(-pq.y(), pq.x()) / 2;
      const Planar_point dirichlet_gradient = (t.cot_q * xp + t.cot_p * xq) / 2;
      const Planar_point ratio_gradient = (dirichlet_gradient - ratio * area_gradient) / area;
      const Eigen::Matrix2d mixed = ratio_gradient * area_gradient.transpose();
      gradient += t.area * ratio_gradient;
      hessian +=
          t.area / area * ((t.cot_p + t.cot_q) / 2 * Eigen::Matrix2d::Identity() - mixed - mixed.transpose());
    }
  }
};

// Moves a vertex by one step of Newton's method towards the least energy of its star. Returns `false` if it stays
// where it is.
template <typename Star>
bool relax_vertex(const Star& star, Planar_point& place)
{
  typedef typename Star::Energy Energy;
  if(!is_valid(star, place))
    return false;
  const Energy here(star, place, true);
  const double determinant =
      here.hessian(0, 0) * here.hessian(1, 1) - here.hessian(0, 1) * here.hessian(0, 1);
  Planar_point step;
  if(determinant > 0 && here.hessian.trace() > 0)
    step = Planar_point(here.hessian(0, 1) * here.gradient.y() - here.hessian(1, 1) * here.gradient.x(),
                        here.hessian(0, 1) * here.gradient.x() - here.hessian(0, 0) * here.gradient.y()) /
           determinant;
  else
    step = -here.gradient / (here.hessian.cwiseAbs().sum() + (std::numeric_limits<double>::min)());
  for(int halvings = 0; halvings < 5; ++halvings, step /= 2) {
    const Planar_point next = place + step;
    if(is_valid(star, next) && Energy(star, next, false).value < here.value) {
      place = next;
      return true;
    }
  }
  return false;
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_RELAX_VERTEX_H
