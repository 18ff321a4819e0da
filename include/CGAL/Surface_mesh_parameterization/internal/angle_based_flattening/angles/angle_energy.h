// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of angles: the relative squares of Eq. 1, and a barrier that keeps angles from vanishing.
// `solve_angles()` minimizes it, and injective maps and relaxed vertices do in the plane. `measure_chart.h` reports it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_ANGLE_ENERGY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_ANGLE_ENERGY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The energy of one corner as a function of its angle alpha, with t = alpha / beta:
//   (t - 1)^2 + barrier (t - 1 - ln t)
// The first term is Eq. 1 with the relative weights 1 / beta^2; the second has the same minimum and grows
// without bound as the angle vanishes.
struct Angle_energy
{
  double barrier = 0;

  double value(double alpha, double beta) const
  {
    const double x = alpha / beta - 1;
    return x * x + (barrier > 0 ? barrier * (x - std::log1p(x)) : 0);
  }

  // The sum over the corners of a triangle, with one logarithm
  double value(const std::array<double, 3>& alpha, const std::array<double, 3>& beta) const
  {
    double squares = 0, sum = 0, product = 1;
    for(int k = 0; k < 3; ++k) {
      const double t = alpha[k] / beta[k];
      squares += (t - 1) * (t - 1);
      sum += t - 1;
      product *= t;
    }
    return squares + (barrier > 0 ? barrier * (sum - std::log(product)) : 0);
  }

  double first_derivative(double alpha, double beta) const
  {
    return (2 * (alpha - beta) / beta + barrier * (1 - beta / alpha)) / beta;
  }

  double second_derivative(double alpha, double beta) const
  {
    return 2 / (beta * beta) + barrier / (alpha * alpha);
  }

  double value(const std::vector<double>& alpha, const std::vector<double>& beta) const
  {
    return parallel_sum(static_cast<int>(alpha.size()), [&](int c) { return value(alpha[c], beta[c]); });
  }

  // With a weight for each triangle, or none
  double value(const std::vector<double>& alpha, const std::vector<double>& beta,
               const std::vector<double>& weight) const
  {
    if(weight.empty())
      return value(alpha, beta);
    return parallel_sum(static_cast<int>(alpha.size()),
                        [&](int c) { return weight[c / 3] * value(alpha[c], beta[c]); });
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_ANGLE_ENERGY_H
