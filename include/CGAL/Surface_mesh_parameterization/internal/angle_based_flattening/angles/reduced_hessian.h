// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_REDUCED_HESSIAN_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_REDUCED_HESSIAN_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The Hessian may fall to this part of the energy's before it is lifted, so that it stays definite.
inline constexpr double least_relative_curvature = 0.1;

// An orthonormal basis of the plane d_1 + d_2 + d_3 = 0 of the steps that keep a triangle's sum of angles.
typedef Eigen::Matrix<double, 3, 2> Sum_preserving_steps;

inline const Sum_preserving_steps& basis_of_sum_preserving_steps()
{
  static const Sum_preserving_steps basis = (Sum_preserving_steps() << std::sqrt(0.5), std::sqrt(1. / 6),
                                             -std::sqrt(0.5), std::sqrt(1. / 6), 0, -std::sqrt(2. / 3))
                                                .finished();
  return basis;
}

// The inverse of a symmetric matrix whose eigenvalues relative to those of the definite matrix `metric` are lifted to
// `least_relative_curvature` where they are less.
inline Eigen::Matrix2d lifted_inverse(const Eigen::Matrix2d& matrix, const Eigen::Matrix2d& metric)
{
  // With a Cholesky factor L of the metric, these are the eigenvalues of L^-1 A L'^-1.
  const double l00 = std::sqrt(metric(0, 0)), l10 = metric(1, 0) / l00,
               l11 = std::sqrt(metric(1, 1) - l10 * l10);
  Eigen::Matrix2d inverse_factor;
  inverse_factor << 1 / l00, 0, -l10 / (l00 * l11), 1 / l11;
  const Eigen::Matrix2d relative = inverse_factor * matrix * inverse_factor.transpose();

  const double mean = relative.trace() / 2;
  const double radius = std::hypot((relative(0, 0) - relative(1, 1)) / 2, relative(0, 1));
  const auto inverse = [](double eigenvalue) { return 1 / (std::max)(eigenvalue, least_relative_curvature); };
  // A function of a matrix is the line through its values at both eigenvalues.
  const double slope =
      radius > 1e-14 * std::abs(mean) ? (inverse(mean + radius) - inverse(mean - radius)) / (2 * radius) : 0;
  const Eigen::Matrix2d inverse_relative = inverse(mean - radius) * Eigen::Matrix2d::Identity() +
                                           slope * (relative - (mean - radius) * Eigen::Matrix2d::Identity());
  return inverse_factor.transpose() * inverse_relative * inverse_factor;
}

// Both matrix splits of the paper (Eqs. 7 to 17), for one triangle.
//
// Eq. 6 for the angles of a triangle reads H d + B' dlambda + mu 1 = r, with the diagonal Hessian H of the
// Lagrangian, the Jacobian B of the constraints at its vertices, and the multiplier mu of its own constraint
// d_1 + d_2 + d_3 = 0. The first split (Eq. 10) eliminates d, the second (Eq. 17) mu; together
//   d = P (r - B' dlambda)   with   P = T (T' H T)^-1 T',
// T being a basis of the steps with sum zero. Summed over all triangles, B d = -C then is Eq. 16.
//
// Returns (T' H T)^-1. `curvature` is the diagonal of H; where H is less than `least_relative_curvature` times the
// energy's own Hessian in some direction of the plane, it is lifted to that.
inline Eigen::Matrix2d reduced_hessian_inverse(const Eigen::Vector3d& energy_curvature,
                                               const Eigen::Vector3d& curvature)
{
  const Sum_preserving_steps& basis = basis_of_sum_preserving_steps();
  const Eigen::Matrix2d energy_hessian = basis.transpose() * energy_curvature.asDiagonal() * basis;
  const Eigen::Matrix2d hessian = basis.transpose() * curvature.asDiagonal() * basis;
  return lifted_inverse(hessian, energy_hessian);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_REDUCED_HESSIAN_H
