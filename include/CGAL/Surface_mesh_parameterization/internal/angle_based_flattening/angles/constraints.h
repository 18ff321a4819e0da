// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The constraints at the nodes: planarity (Eq. 3) and reconstruction (Eq. 4), the latter in logarithms. Holes and loops
// join them here. `solve_angles.h` looks at their residuals, and `newton_system.h` needs their derivatives. The exact
// layout takes its cotangents from here.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_CONSTRAINTS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_CONSTRAINTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/hole_equations.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/loop_equations.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Free node i has the constraints 2i (planarity) and 2i + 1 (reconstruction). With n free nodes and h holes, hole k has
// the constraints 2 (n + k) (rotation), 2 (n + k) + 1 (scale), 2 (n + h + k) and 2 (n + h + k) + 1 (translation). The
// constraints of triangles (Eq. 2) hold at the start, and every step keeps them.
typedef Eigen::VectorXd Constraint_vector;

inline int number_of_constraints(const Chart& chart)
{
  return 2 * (chart.number_of_free_nodes() + 2 * chart.number_of_holes());
}

// Replaces the residuals of bound nodes by the equations of their holes.
inline void set_hole_residuals(const Chart& chart, const std::vector<double>& alpha,
                               Constraint_vector& residual)
{
  const int n = chart.number_of_free_nodes(), h = chart.number_of_holes();
  residual.conservativeResize(number_of_constraints(chart));
  const std::vector<Hole_equations> holes = hole_equations(chart, alpha);
  for(int k = 0; k < h; ++k) {
    residual[2 * (n + k)] = holes[k].rotation;
    residual[2 * (n + k) + 1] = holes[k].scale;
    residual[2 * (n + h + k)] = holes[k].gap.real();
    residual[2 * (n + h + k) + 1] = holes[k].gap.imag();
  }
}

// Adds what the corners from `first` on contribute. `log_sines` begins with that of `first`.
inline void add_residuals(const Chart& chart, const std::vector<double>& alpha, int first, int last,
                          const std::vector<double>& log_sines, Constraint_vector& residual)
{
  for(int c = first; c < last; ++c) {
    const int i = chart.node_of_corner(c);
    if(i >= 0)
      residual[2 * i] += alpha[c];
    const int before = chart.node_of_corner(previous_corner(c));
    const int after = chart.node_of_corner(next_corner(c));
    if(before >= 0)
      residual[2 * before + 1] += log_sines[c - first];
    if(after >= 0)
      residual[2 * after + 1] -= log_sines[c - first];
  }
}

// Planarity (Eq. 3): the angles at an interior vertex sum to 2 pi, and the angles at any other node to its target.
// Reconstruction (Eq. 4), as the logarithm of the ratio of its two products:
//   sum ln sin alpha_{k+1} - sum ln sin alpha_{k-1} = 0
// It has the same solutions, cannot underflow, and its second derivative is diagonal.
// The memory of `log_sines` is used.
inline void find_constraint_residuals(const Chart& chart, const std::vector<double>& alpha,
                                      std::vector<double>& log_sines, Constraint_vector& residual)
{
  residual = Constraint_vector::Zero(2 * chart.number_of_nodes());
  for(int i = 0; i < chart.number_of_nodes(); ++i)
    residual[2 * i] = -chart.nodes[i].angle_sum;
  const int at_once = 32 * block_size, corners = chart.number_of_corners();
  for(int first = 0; first < corners; first += at_once) {
    const int size = (std::min)(corners - first, at_once);
    log_sines.resize((std::max)(log_sines.size(), static_cast<std::size_t>(size)));
    parallel_for_blocks(size, [&](int begin, int end) {
      for(int c = begin; c < end; ++c)
        log_sines[c] = std::log(std::sin(alpha[first + c]));
    });
    add_residuals(chart, alpha, first, first + size, log_sines, residual);
  }
  add_loop_residuals(chart, alpha, residual);
  for(int i = 0; i < chart.number_of_nodes(); ++i) {
    if(!chart.nodes[i].has_planarity)
      residual[2 * i] = 0;
    if(!chart.nodes[i].has_reconstruction)
      residual[2 * i + 1] = 0;
  }
  if(chart.number_of_holes() > 0)
    set_hole_residuals(chart, alpha, residual);
}

inline Constraint_vector constraint_residuals(const Chart& chart, const std::vector<double>& alpha)
{
  std::vector<double> log_sines;
  Constraint_vector residual;
  find_constraint_residuals(chart, alpha, log_sines, residual);
  return residual;
}

// The largest violation of a constraint. The gaps of holes count tenfold: a layout that closes them then changes angles
// little, even if the tolerance is large.
inline double largest_violation(const Chart& chart, const Constraint_vector& residual)
{
  const Eigen::Index gaps = 2 * chart.number_of_holes(), others = residual.size() - gaps;
  double largest = others > 0 ? residual.head(others).cwiseAbs().maxCoeff() : 0;
  for(Eigen::Index i = others; i < residual.size(); i += 2)
    largest =
        (std::max)(largest, 10 * std::sqrt(residual[i] * residual[i] + residual[i + 1] * residual[i + 1]));
  return largest;
}

inline Vector_3 cotangents(const std::vector<double>& alpha, int triangle)
{
  Vector_3 result;
  for(int k = 0; k < 3; ++k)
    result[k] = std::cos(alpha[3 * triangle + k]) / std::sin(alpha[3 * triangle + k]);
  return result;
}

// The second derivative of the sum of all nodes' constraints times their multipliers with respect to the angle at
// corner `c`; derivatives with respect to two different angles vanish.
inline double constraint_curvature(const Chart& chart, const Constraint_vector& multipliers, int c,
                                   double cotangent)
{
  const int before = chart.node_of_corner(previous_corner(c));
  const int after = chart.node_of_corner(next_corner(c));
  const double difference =
      (before >= 0 ? multipliers[2 * before + 1] : 0) - (after >= 0 ? multipliers[2 * after + 1] : 0);
  const double of_loops =
      chart.number_of_loops > 0 ? Loop_equations(chart).curvature(multipliers, c, cotangent) : 0;
  return of_loops - difference * (1 + cotangent * cotangent);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_CONSTRAINTS_H
