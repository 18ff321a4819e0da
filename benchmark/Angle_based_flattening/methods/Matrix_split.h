// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_MATRIX_SPLIT_H
#define ABF_BENCHMARK_MATRIX_SPLIT_H

#include "Lagrangian.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/symmetric_system.h>

namespace ABF_benchmark {

// Solves Eq. 6 by the two matrix splits of Section 3, in the paper's own matrices.
class Matrix_split
{
public:
  explicit Matrix_split(const Lagrangian& lagrangian) : m_lagrangian(lagrangian), m_system(Solver()) {}

  bool operator()(const Vector& x, const Vector& gradient, Vector& step)
  {
    const int n_alpha = m_lagrangian.number_of_angles(), n_f = n_alpha / 3;
    const int n_lambda = m_lagrangian.number_of_constraints(), n_2 = n_lambda - n_f;
    const Vector inverse = m_lagrangian.energy_curvature().cwiseInverse(); // Lambda^-1
    const Matrix j = m_lagrangian.jacobian(x);
    const Matrix j_1 = j.topRows(n_f), j_2 = j.bottomRows(n_2); // Eq. 11
    const Vector b_1 = -gradient.head(n_alpha);
    const Vector b = j * inverse.cwiseProduct(b_1) + gradient.tail(n_lambda); // b* of Eq. 9

    const Matrix j_2_lambda = j_2 * inverse.asDiagonal(); // Eq. 12
    const Matrix star = j_2_lambda * j_1.transpose();
    const Matrix star_star = j_2_lambda * j_2.transpose();
    Vector star_inverse(n_f);
    for(int t = 0; t < n_f; ++t)
      star_inverse[t] = 1 / inverse.segment<3>(3 * t).sum();

    Vector lambda(n_lambda), lambda_2(0);
    if(n_2 > 0) { // Eq. 16, with the sign that makes its matrix positive definite
      const Matrix weighted = star * star_inverse.asDiagonal();
      const Matrix product = weighted * star.transpose();
      const Matrix s = star_star - product;
      if(!m_system.set_matrix(s) || !m_system.solve(b.tail(n_2) - weighted * b.head(n_f), lambda_2))
        return false;
    }
    lambda.head(n_f) = star_inverse.cwiseProduct(b.head(n_f) - star.transpose() * lambda_2); // Eq. 17
    lambda.tail(n_2) = lambda_2;
    step.resize(x.size());
    step.head(n_alpha) = inverse.cwiseProduct(b_1 - j.transpose() * lambda); // Eq. 10
    step.tail(n_lambda) = lambda;
    return true;
  }

private:
  const Lagrangian& m_lagrangian;
  abf::Symmetric_system<Solver> m_system;
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_MATRIX_SPLIT_H
