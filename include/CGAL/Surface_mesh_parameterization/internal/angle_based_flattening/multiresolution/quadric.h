// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The quadratic form that tells which volume a collapse sweeps: a sum of squared products with the normals of a star.
// `collapse_cost.h` sums one for each vertex, and evaluates it for all its collapses.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_QUADRIC_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_QUADRIC_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A quadratic form in space. Its six coefficients are separate members, so that they stay in registers during
// summation.
struct Quadric
{
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;

  // Adds `factor` times the square of the dot product with `n`.
  void add(const Eigen::Vector3d& n, double factor)
  {
    const double x = factor * n.x(), y = factor * n.y();
    xx += x * n.x();
    yy += y * n.y();
    zz += factor * n.z() * n.z();
    xy += x * n.y();
    xz += x * n.z();
    yz += y * n.z();
  }

  void add_identity(double factor)
  {
    xx += factor;
    yy += factor;
    zz += factor;
  }

  double trace() const { return xx + yy + zz; }

  double operator()(const Eigen::Vector3d& d) const
  {
    return d.x() * (xx * d.x() + 2 * (xy * d.y() + xz * d.z())) + d.y() * (yy * d.y() + 2 * yz * d.z()) +
           zz * d.z() * d.z();
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_QUADRIC_H
