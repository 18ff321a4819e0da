// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Both matrix splits of ABF++ (Eqs. 7 to 17) for one triangle: they leave a matrix of two rows, which is inverted here.
// `newton_system.h` and `loop_equations.h` sum up the results. A Hessian that is not definite is lifted.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_REDUCED_HESSIAN_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_REDUCED_HESSIAN_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The Hessian may fall to this part of the energy's before it is lifted, so that it stays definite.
inline constexpr double least_relative_curvature = 0.1;

// An orthonormal basis of the plane d_1 + d_2 + d_3 = 0 of the steps that keep a triangle's sum of angles.
typedef Small_matrix<3, 2> Sum_preserving_steps;

inline const Sum_preserving_steps& basis_of_sum_preserving_steps()
{
  static const Sum_preserving_steps basis = {
      {std::sqrt(0.5), -std::sqrt(0.5), 0, std::sqrt(1. / 6), std::sqrt(1. / 6), -std::sqrt(2. / 3)}};
  return basis;
}

// The inverse of a symmetric matrix whose eigenvalues relative to those of the definite matrix `metric` are lifted to
// `least_relative_curvature` where they are less.
inline Matrix_2 lifted_inverse(const Matrix_2& matrix, const Matrix_2& metric)
{
  // With a Cholesky factor L of the metric, these are the eigenvalues of L^-1 A L'^-1.
  const double l00 = std::sqrt(metric(0, 0)), l10 = metric(1, 0) / l00,
               l11 = std::sqrt(metric(1, 1) - l10 * l10);
  const Matrix_2 inverse_factor = {{1 / l00, -l10 / (l00 * l11), 0, 1 / l11}};
  const Matrix_2 relative = inverse_factor * matrix * transposed(inverse_factor);

  const double mean = (relative(0, 0) + relative(1, 1)) / 2;
  const double radius = std::hypot((relative(0, 0) - relative(1, 1)) / 2, relative(0, 1));
  const auto inverse = [](double eigenvalue) { return 1 / (std::max)(eigenvalue, least_relative_curvature); };
  // A function of a matrix is the line through its values at both eigenvalues.
  const double slope =
      radius > 1e-14 * std::abs(mean) ? (inverse(mean + radius) - inverse(mean - radius)) / (2 * radius) : 0;
  const Matrix_2 identity = {{1, 0, 0, 1}};
  const Matrix_2 inverse_relative =
      inverse(mean - radius) * identity + slope * (relative - (mean - radius) * identity);
  return transposed(inverse_factor) * inverse_relative * inverse_factor;
}

// Both matrix splits of the paper (Eqs. 7 to 17), for one triangle.
//
// Eq. 6 for the angles of a triangle reads Lambda d + J_1' dlambda_1 + J_2' dlambda_2 = b_1, with the diagonal Hessian
// Lambda of the Lagrangian, the row J_1 = (1 1 1) of its own constraint, d_1 + d_2 + d_3 = 0, and the Jacobian J_2 of
// the constraints at its vertices. The first split (Eq. 10) eliminates d, the second (Eq. 17) dlambda_1. With
// Lambda* = J_1 Lambda^-1 J_1', J* = J_2 Lambda^-1 J_1' and J** = J_2 Lambda^-1 J_2' (Eq. 12), both together leave
//   J** - J* Lambda*^-1 J*' = J_2 P J_2'   with   P = Lambda^-1 - Lambda^-1 J_1' Lambda*^-1 J_1 Lambda^-1,
// the negative of the matrix of Eq. 16, and d = P (b_1 - J_2' dlambda_2). As P maps to steps with sum zero, it is
//   P = T (T' Lambda T)^-1 T',
// T being a basis of these steps. Summed over all triangles, J_2 d = -C then is Eq. 16.
//
// Returns (T' Lambda T)^-1. `curvature` is the diagonal of Lambda; where Lambda is less than `least_relative_curvature`
// times the energy's own Hessian in some direction of the plane, it is lifted to that.
inline Matrix_2 reduced_hessian_inverse(const Vector_3& energy_curvature, const Vector_3& curvature)
{
  const Sum_preserving_steps& basis = basis_of_sum_preserving_steps();
  const auto reduced = [&](const Vector_3& diagonal) {
    Small_matrix<2, 3> scaled = transposed(basis);
    for(int k = 0; k < 3; ++k)
      for(int i = 0; i < 2; ++i)
        scaled(i, k) *= diagonal[k];
    return scaled * basis;
  };
  return lifted_inverse(reduced(curvature), reduced(energy_curvature));
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_REDUCED_HESSIAN_H
