// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_NEWTON_SYSTEMS_H
#define SOLVERS_NEWTON_SYSTEMS_H

#include "Linear_system.h"

#include "../common/resize_mesh.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/newton_step.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>

#include <stdexcept>
#include <vector>

namespace solvers {

using namespace benchmarks;

// The matrix of the planarity multipliers alone, which are those of even numbers
inline Linear_system planarity_block(const Linear_system& full)
{
  Linear_system block;
  const int n = full.order() / 2;
  Linear_system::Columns& columns = block.columns();
  columns.resize(n, n);
  columns.reserve(static_cast<Eigen::Index>(full.nonzeros() / 4));
  for(int j = 0; j < n; ++j) {
    columns.startVec(j);
    for(Linear_system::Columns::InnerIterator it(full.columns(), 2 * j); it; ++it) {
      if(it.row() % 2 == 0) {
        columns.insertBack(it.row() / 2, j) = it.value();
      }
    }
  }
  columns.finalize();
  block.right_side.eigen_object() =
      Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<2>>(full.right_side.eigen_object().data(), n);
  return block;
}

// The linear system of the first Newton step: Eq. 16 at the angles where the solver starts.
inline Linear_system first_newton_system(const Mesh& mesh)
{
  namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;
  abf::Chart_reader<Mesh> reader(mesh);
  if(const auto defect = reader.read(CGAL::Polygon_mesh_processing::longest_border(mesh).first)) {
    throw std::runtime_error("the mesh cannot be flattened: " + defect.message);
  }
  const abf::Chart& chart = reader.chart;
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

} // namespace solvers

#endif // SOLVERS_NEWTON_SYSTEMS_H
