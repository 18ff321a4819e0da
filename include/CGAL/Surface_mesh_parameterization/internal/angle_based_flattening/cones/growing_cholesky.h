// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONES_GROWING_CHOLESKY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONES_GROWING_CHOLESKY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The Cholesky factor of a small dense matrix that gets one row and column after the other
class Growing_cholesky
{
public:
  // Appends the last column of a larger matrix. Returns `false` if that is not positive definite.
  bool append(const Eigen::VectorXd& column)
  {
    const Eigen::Index n = m_factor.rows();
    const Eigen::VectorXd row =
        m_factor.triangularView<Eigen::Lower>().solve(Eigen::VectorXd(column.head(n)));
    const double square = column[n] - row.squaredNorm();
    if(!(square > 0))
      return false;
    m_factor.conservativeResize(n + 1, n + 1);
    m_factor.row(n).head(n) = row.transpose();
    m_factor(n, n) = std::sqrt(square);
    return true;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const
  {
    Eigen::VectorXd solution = m_factor.triangularView<Eigen::Lower>().solve(right_hand_side);
    m_factor.triangularView<Eigen::Lower>().transpose().solveInPlace(solution);
    return solution;
  }

private:
  Eigen::MatrixXd m_factor; // its lower triangle
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONES_GROWING_CHOLESKY_H
