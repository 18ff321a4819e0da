// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_TEST_SMALL_MATRICES_H
#define ANGLE_BASED_FLATTENING_TEST_SMALL_MATRICES_H

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>

#include <Eigen/Core>

namespace small_matrices {

namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;

template <int Rows, int Columns>
Eigen::Matrix<double, Rows, Columns> eigen(const abf::Small_matrix<Rows, Columns>& a)
{
  return Eigen::Map<const Eigen::Matrix<double, Rows, Columns>>(a.entry);
}

template <int Rows, int Columns>
abf::Small_matrix<Rows, Columns> small(const Eigen::Matrix<double, Rows, Columns>& a)
{
  abf::Small_matrix<Rows, Columns> result;
  Eigen::Map<Eigen::Matrix<double, Rows, Columns>>(result.entry) = a;
  return result;
}

} // namespace small_matrices

#endif // ANGLE_BASED_FLATTENING_TEST_SMALL_MATRICES_H
