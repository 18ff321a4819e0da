// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MATRIX_SPLITS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MATRIX_SPLITS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The Hessian may fall to this part of the energy's before it is lifted, so that it stays definite.
constexpr double least_relative_curvature = 0.1;

// An orthonormal basis of the plane d_1 + d_2 + d_3 = 0 of the steps that keep a triangle's sum of angles.
inline Eigen::Matrix<double, 3, 2> basis_of_sum_preserving_steps()
{
  Eigen::Matrix<double, 3, 2> basis;
  basis << std::sqrt(0.5), std::sqrt(1. / 6), -std::sqrt(0.5), std::sqrt(1. / 6), 0, -std::sqrt(2. / 3);
  return basis;
}

// Both matrix splits of the paper (Eqs. 7 to 17), for one triangle.
//
// Eq. 6 for the angles of a triangle reads H d + B' dlambda + mu 1 = r, with the diagonal Hessian H of the
// Lagrangian, the Jacobian B of the constraints at its vertices, and the multiplier mu of its own constraint
// d_1 + d_2 + d_3 = 0. The first split (Eq. 10) eliminates d, the second (Eq. 17) mu; together
//   d = P (r - B' dlambda)   with   P = T (T' H T)^-1 T',
// T being a basis of the steps with sum zero. Summed over all triangles, B d = -C then is Eq. 16.
//
// Returns P. `curvature` is the diagonal of H; where H is less than `least_relative_curvature` times the energy's
// own Hessian in some direction of the plane, it is lifted to that.
inline Eigen::Matrix3d split(const Eigen::Vector3d& energy_curvature, const Eigen::Vector3d& curvature)
{
  static const Eigen::Matrix<double, 3, 2> basis = basis_of_sum_preserving_steps();
  const Eigen::Matrix2d energy_hessian = basis.transpose() * energy_curvature.asDiagonal() * basis;
  const Eigen::Matrix2d hessian = basis.transpose() * curvature.asDiagonal() * basis;

  const Eigen::Matrix2d margin = hessian - least_relative_curvature * energy_hessian;
  if(margin.trace() > 0 && margin.determinant() > 0)
    return basis * hessian.inverse() * basis.transpose();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> eigen(hessian, energy_hessian);
  const Eigen::Vector2d lifted = eigen.eigenvalues().cwiseMax(least_relative_curvature);
  const Eigen::Matrix<double, 3, 2> directions = basis * eigen.eigenvectors();
  return directions * lifted.cwiseInverse().asDiagonal() * directions.transpose();
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MATRIX_SPLITS_H
