// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The move of one vertex that lowers the energy of its star: the relaxation of Section 5.2, usually with the energy
// MIPS. `relaxation.h` and `border_keeper.h` call it. The paper smooths harmonically instead, which lets stretch grow.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAX_VERTEX_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAX_VERTEX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_energies.h>

#include <cmath>
#include <limits>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A step of Newton's method towards the least energy of a star, or along the gradient where the energy is not convex
inline Planar_point newton_step(const Energy_derivatives<2>& here)
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
