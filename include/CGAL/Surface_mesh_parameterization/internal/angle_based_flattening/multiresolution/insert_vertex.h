// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The position of a vertex that is put back (Section 5.2): harmonic weights, Eq. 22 at the border, then the kernel of
// the star. `refine.h` calls it for each vertex of a level. Mean value weights, and points on the way to them, are
// tried beyond the paper.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_INSERT_VERTEX_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_INSERT_VERTEX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The position of a vertex by harmonic weights (Section 5.2, step 1), or by Eq. 22 at the border. (The paper prints
// the same cotangent twice there. Correct are the cotangents of both other corners.)
inline Planar_point harmonic_position(const Planar_star& star)
{
  Planar_point sum(0, 0);
  double weights = 0;
  for(const Planar_star::Triangle& t : star.triangles) {
    sum += t.cot_q * t.p + t.cot_p * t.q;
    if(star.on_border)
      sum += Planar_point(t.p.y() - t.q.y(), t.q.x() - t.p.x());
    weights += t.cot_p + t.cot_q;
  }
  return sum / weights;
}

// The same with mean value weights. They are positive, and less extreme at obtuse angles.
inline Planar_point mean_value_position(const Planar_star& star)
{
  Planar_point sum(0, 0);
  double weights = 0;
  for(const Planar_star::Triangle& t : star.triangles) {
    const double half_tangent = std::sqrt(1 + t.cot_v * t.cot_v) - t.cot_v;
    const double twice_area = 2 * t.area;
    // The edges from the vertex have squared lengths twice_area * (cot_v + cot_q) and (cot_v + cot_p).
    const double weight_p = half_tangent / std::sqrt(twice_area * (t.cot_v + t.cot_p));
    const double weight_q = half_tangent / std::sqrt(twice_area * (t.cot_v + t.cot_q));
    sum += weight_p * t.p + weight_q * t.q;
    weights += weight_p + weight_q;
  }
  return sum / weights;
}

// The part of a convex polygon to the left of the line from `a` to `b`.
inline std::vector<Planar_point> clipped(const std::vector<Planar_point>& polygon, const Planar_point& a,
                                         const Planar_point& b)
{
  std::vector<Planar_point> result;
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const Planar_point &x = polygon[i], &y = polygon[(i + 1) % polygon.size()];
    const double at_x = cross(b - a, x - a), at_y = cross(b - a, y - a);
    if(at_x >= 0)
      result.push_back(x);
    if((at_x > 0 && at_y < 0) || (at_x < 0 && at_y > 0))
      result.push_back(x + at_x / (at_x - at_y) * (y - x));
  }
  return result;
}

// The centre of the kernel of the star (Section 5.2, step 2), or NaN if the kernel is empty.
inline Planar_point kernel_centre(const Planar_star& star)
{
  Planar_point low = star.triangles.front().p, high = low;
  for(const Planar_star::Triangle& t : star.triangles) {
    low = low.cwiseMin(t.p).cwiseMin(t.q);
    high = high.cwiseMax(t.p).cwiseMax(t.q);
  }
  if(star.on_border) {
    const Planar_point margin = (high - low).maxCoeff() * Planar_point(1, 1);
    low -= margin;
    high += margin;
  }
  std::vector<Planar_point> kernel{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  for(const Planar_star::Triangle& t : star.triangles)
    kernel = clipped(kernel, t.p, t.q);
  if(kernel.empty())
    return Planar_point::Constant((std::numeric_limits<double>::quiet_NaN)());
  Planar_point sum(0, 0);
  for(const Planar_point& x : kernel)
    sum += x;
  return sum / static_cast<double>(kernel.size());
}

enum Insertion
{
  INSERTED,
  INSERTED_IN_KERNEL,
  NOT_INSERTED
};

// The energy that relaxation lowers, up to a factor; infinite where the star is not valid.
inline double similarity_energy(const Planar_star& star, const Planar_point& x)
{
  if(!is_valid(star, x))
    return (std::numeric_limits<double>::infinity)();
  double sum = 0;
  for(const Planar_star::Triangle& t : star.triangles)
    sum += t.area *
           (t.cot_q * (x - t.p).squaredNorm() + t.cot_p * (x - t.q).squaredNorm() +
            t.cot_v * (t.p - t.q).squaredNorm()) /
           cross(t.p - x, t.q - x);
  return sum;
}

// Where weights give no valid position: the best one of the centre of the kernel and some on the way from the vertex
// into which the vertex had been merged, at `merged`, to the position by mean value weights
inline Insertion insert_elsewhere(const Planar_star& star, const Planar_point& merged,
                                  const Planar_point& mean_value, Planar_point& position)
{
  position = kernel_centre(star);
  double least = similarity_energy(star, position);
  Insertion insertion = std::isfinite(least) ? INSERTED_IN_KERNEL : NOT_INSERTED;
  for(double part : {0.75, 0.5, 0.25}) {
    const Planar_point x = merged + part * (mean_value - merged);
    if(const double energy = similarity_energy(star, x); energy < least) {
      position = x;
      least = energy;
      insertion = INSERTED;
    }
  }
  return insertion;
}

// Finds a position for a vertex in its star. `position` is that of the vertex into which it had been merged, or near to
// it.
inline Insertion insert_vertex(const Planar_star& star, Planar_point& position)
{
  const Planar_point merged = position;
  position = harmonic_position(star);
  if(is_valid(star, position))
    return INSERTED;
  const Planar_point mean_value = position = mean_value_position(star);
  return is_valid(star, position) ? INSERTED : insert_elsewhere(star, merged, mean_value, position);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_INSERT_VERTEX_H
