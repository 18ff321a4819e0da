// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How much the scale of a conformal map will vary over a chart with holes, from one Poisson equation and without a map.
// `strategies/lay_out_angles.h` refuses charts by it, such as long tubes, whose coordinates no number type can hold
// usefully.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PREDICT_SCALE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PREDICT_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/newton_equation.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// How much the scale of a conformal map of a chart with holes varies
struct Scale_prediction
{
  double log_range = 0; // logarithm of the ratio of the largest to the smallest scale
  int far_border = 0;   // the one with the smallest scale
};

// The curvature at each unknown of the scale: 2 pi minus the angles at an interior vertex; for a hole of m vertices,
// the angles around it minus (m + 2) pi.
inline Eigen::VectorXd curvatures(const Chart& chart, const std::vector<double>& angles,
                                  const std::vector<int>& unknown, int n)
{
  Eigen::VectorXd curvature = Eigen::VectorXd::Constant(n, 2 * pi);
  for(int k = 0; k < chart.number_of_holes(); ++k)
    curvature[chart.number_of_interior_vertices + k] = (static_cast<double>(chart.hole(k).size()) + 2) * pi;
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(const int i = unknown[chart.vertex[c]]; i >= 0)
      curvature[i] -= angles[c];
  return curvature;
}

// The logarithm u of the scale solves the Poisson equation with the curvature as its source: L u = -K for the cotangent
// Laplacian L, whose weights are half the ones here, with u = 0 at the outer border. The scale is about constant around
// a hole, which is therefore one unknown. A tube whose length is t circumferences has the range exp(2 pi t).
inline std::optional<Scale_prediction> predict_scale(const Chart& chart, const Linear_solvers& solvers)
{
  const std::vector<int> unknown = unknown_translations(chart);
  const int n = chart.number_of_interior_vertices + chart.number_of_holes();
  std::vector<double> angles(chart.vertex.size());
  for(int c = 0; c < chart.number_of_corners(); ++c)
    angles[c] = (std::min)((std::max)(surface_angle(chart, c), least_target_angle), pi - least_target_angle);

  Two_vectors sources = {-2 * curvatures(chart, angles, unknown, n), Eigen::VectorXd::Zero(n)}, solutions;
  const Triangle_assembly<1> laplacian = cotangent_laplacian(chart, cotangents(angles), unknown, n);
  if(!solve_definite(laplacian.matrix(), *solvers->low_precision(), sources, solutions))
    return std::nullopt;

  const Eigen::VectorXd& u = solutions[0];
  Scale_prediction prediction;
  prediction.log_range = (std::max)(u.maxCoeff(), 0.) - (std::min)(u.minCoeff(), 0.);
  double least = 0;
  for(int k = 0; k < chart.number_of_holes(); ++k)
    if(const double scale = u[chart.number_of_interior_vertices + k]; scale < least) {
      least = scale;
      prediction.far_border = k + 1;
    }
  return prediction;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PREDICT_SCALE_H
