// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_LINEAR_SYSTEM_H
#define ABF_BENCHMARK_LINEAR_SYSTEM_H

#include "read_mesh.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Eigen_sparse_matrix.h>
#include <CGAL/Eigen_vector.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/newton_step.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>

#include <vector>

namespace ABF_benchmark {

// A square matrix that stores both triangles, and a right-hand side, in the types that CGAL's solvers take
struct Linear_system
{
  typedef Eigen::SparseMatrix<double> Columns;

  CGAL::Eigen_sparse_matrix<double> matrix{0, 0};
  CGAL::Eigen_vector<double> right_side{0};

  Columns& columns() { return matrix.eigen_object(); }
  const Columns& columns() const { return matrix.eigen_object(); }
  int order() const { return static_cast<int>(columns().rows()); }
};

// The linear system of the first Newton step: Eq. 16 at the angles where the solver starts.
inline Linear_system first_newton_system(const abf::Chart& chart)
{
  const std::vector<double> beta = abf::target_angles(chart);
  const std::vector<double> alpha = abf::starting_angles(beta);
  const abf::Constraint_vector residuals = abf::constraint_residuals(chart, alpha);
  const abf::Constraint_vector no_multipliers = abf::Constraint_vector::Zero(residuals.size());

  const CGAL::Surface_mesh_parameterization::ABF_plus_plus_options options;
  abf::Newton_system newton(chart, beta, abf::Angle_energy{options.barrier}, true,
                            CGAL::Eigen_solver_traits<>());
  Linear_system system;
  system.right_side.eigen_object() = newton.assemble(alpha, no_multipliers, residuals);
  system.columns() = abf::eigen_matrix<double>(newton.matrix());
  return system;
}

// That of the planarity multipliers alone, which are those of even numbers
inline Linear_system planarity_block(const Linear_system& full)
{
  Linear_system block;
  const int n = full.order() / 2;
  Linear_system::Columns& columns = block.columns();
  columns.resize(n, n);
  columns.reserve(full.columns().nonZeros() / 4);
  for(int j = 0; j < n; ++j) {
    columns.startVec(j);
    for(Linear_system::Columns::InnerIterator it(full.columns(), 2 * j); it; ++it)
      if(it.row() % 2 == 0)
        columns.insertBack(it.row() / 2, j) = it.value();
  }
  columns.finalize();
  block.right_side.eigen_object() =
      Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<2>>(full.right_side.eigen_object().data(), n);
  return block;
}

// Changes the values of the matrix, by scaling some of its rows and the columns alike: it stays definite.
inline void change_values(Linear_system& system)
{
  const auto scale = [](const Eigen::Index i) { return 1 + static_cast<double>(i % 5) / 8; };
  for(int j = 0; j < system.order(); ++j)
    for(Linear_system::Columns::InnerIterator it(system.columns(), j); it; ++it)
      it.valueRef() *= scale(it.row()) * scale(j);
}

// |A x - b| / |b|
inline double relative_residual(const Linear_system& system, const CGAL::Eigen_vector<double>& x)
{
  const Eigen::VectorXd& b = system.right_side.eigen_object();
  return (system.columns() * x.eigen_object() - b).norm() / b.norm();
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_LINEAR_SYSTEM_H
