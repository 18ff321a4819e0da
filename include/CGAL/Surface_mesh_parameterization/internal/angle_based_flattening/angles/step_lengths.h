// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_STEP_LENGTHS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_STEP_LENGTHS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/newton_step.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// How far to go along each step. Where the Hessian is lifted to be definite, full steps are too short, all by nearly the
// same factor, and converge only linearly. Two of them tell the factor: this is Anderson acceleration with one vector, after a
// full step.
class Step_lengths
{
  static constexpr double largest_residual = 0.03; // farther away, steps do not tell it yet
  static constexpr double least_excess = 0.4;      // below, the next step is as good without it

public:
  // 1, or more. The constraints are off by `residual` at most.
  double next(const std::vector<double>& beta, const Newton_step& step, double residual) const
  {
    if(!m_last_was_full || residual > largest_residual)
      return 1;
    const int corners = static_cast<int>(beta.size());
    const auto change = [&](int c) { return (step.angles[c] - m_last_angles[c]) / beta[c]; };
    const double product =
        parallel_sum(corners, [&](int c) { return change(c) * (step.angles[c] / beta[c]); });
    const double square = parallel_sum(corners, [&](int c) { return change(c) * change(c); });
    return -product > least_excess * square ? 1 - product / square : 1;
  }

  // Remembers a step, of which a part was taken, and leaves other memory in exchange.
  void remember(Newton_step& step, double length)
  {
    m_last_angles.swap(step.angles);
    m_last_was_full = length == 1;
  }

private:
  std::vector<double> m_last_angles;
  bool m_last_was_full = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_STEP_LENGTHS_H
