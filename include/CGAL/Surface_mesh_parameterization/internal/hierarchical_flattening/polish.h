// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_POLISH_H
#define CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_POLISH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/flatten_from_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Runs the direct solver from the angles of a valid map, which fulfil all constraints. The map is replaced only by
// another valid one; whether it was is in the report.
inline void polish(const Chart& chart, const Hierarchical_options& options, const Linear_solvers& solvers,
                   std::vector<Chart::Point_2>& uv, Hierarchical_report& report)
{
  const std::vector<double> beta = target_angles(chart);
  std::vector<double> alpha(beta.size());
  for(int c = 0; c < chart.number_of_corners(); ++c)
    alpha[c] = planar_angle(chart, uv, c);
  alpha = starting_angles(alpha);

  ABF_plus_plus_report direct;
  std::unique_ptr<Linear_solver> scalar_solver;
  std::vector<Chart::Point_2> polished;
  if(solve_angles(chart, beta, options.polish_options, solvers, alpha, direct, &scalar_solver) &&
     direct.converged &&
     lay_out(chart, alpha, options.polish_options, solvers, std::move(scalar_solver), polished, direct) &&
     flipped_triangles(chart, polished).empty()) {
    uv.swap(polished);
    report.polished = true;
  }
  report.polish_iterations = direct.iterations;
  report.constraint_residual = direct.constraint_residual;
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_POLISH_H
