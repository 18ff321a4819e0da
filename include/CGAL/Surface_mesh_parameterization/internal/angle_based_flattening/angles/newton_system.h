// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One step of Newton's method: sums up the matrix of Eq. 16 over triangles, has it solved, and substitutes back (Eqs.
// 10 and 17). `solve_angles()` calls it in every iteration. The matrix splits of a single triangle are in
// `reduced_hessian.h`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_NEWTON_SYSTEM_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_NEWTON_SYSTEM_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/hole_equations.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/loop_equations.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/reduced_hessian.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/bound_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/newton_equation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/triangle_assembly.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A step of the angles and of the multipliers of the constraints at the nodes.
struct Newton_step
{
  std::vector<double> angles;
  Constraint_vector multipliers;
  double predicted_decrease = 0; // of the quadratic model of the Lagrangian
};

// Computes steps by solving Eq. 16, whose matrix is a sum over triangles:
//   S = sum J_2 P J_2',   S dlambda_2 = C + sum J_2 P b_1,   d = P (b_1 - J_2' dlambda_2)
// with P = T (T' Lambda T)^-1 T', as `reduced_hessian_inverse()` says, and b_1 minus the gradient of the Lagrangian.
// This S is positive definite. With holes, Z' S Z takes its place: see `Bound_matrix`.
class Newton_system
{
public:
  // To save memory, the local systems are computed anew after factorizations.
  Newton_system(const Chart& chart, const std::vector<double>& beta, const Angle_energy& energy,
                bool with_constraint_curvature, const Linear_solvers& solvers, bool iteratively = false,
                bool saves_memory = false)
      : m_chart(chart), m_beta(beta), m_energy(energy),
        m_with_constraint_curvature(with_constraint_curvature), m_saves_memory(saves_memory), m_loops(chart),
        m_assembly(chart.vertex, chart.node, chart.number_of_nodes(), m_loops.nodes()),
        m_equation(solvers, iteratively, chart.number_of_holes())
  {
    if(chart.number_of_holes() > 0)
      m_binding.emplace(holes_of_bound_nodes(chart), chart.number_of_holes(), m_assembly.matrix());
    for(int i = 0; i < chart.number_of_nodes(); ++i)
      if(!chart.nodes[i].is_complete())
        m_incomplete_nodes.push_back(i);
  }

  // Computes the step from angles `alpha` and `multipliers`, where the constraints are violated by `residual`.
  // `accuracy` is for the iterative solver. Returns `false` if the linear solver fails.
  bool compute(const std::vector<double>& alpha, const Constraint_vector& multipliers,
               const Constraint_vector& residual, Newton_step& step,
               const Iterative_accuracy& accuracy = Iterative_accuracy())
  {
    const auto prepare = [&](int k) {
      if(k == 0)
        m_equation.analyze_pattern(matrix());
      else
        assemble(alpha, multipliers, residual);
    };
    parallel_for(2, prepare, m_chart.number_of_triangles());
    const bool needs_memory = m_saves_memory && m_equation.is_to_be_factored();
    if(needs_memory)
      std::vector<Local_system>().swap(m_local);
    if(!m_equation.solve(matrix(), m_right_hand_side, accuracy, step.multipliers))
      return false;
    if(needs_memory)
      set_local_systems(alpha, of_nodes(multipliers));
    substitute_back(step);
    return true;
  }

  // Eq. 16: sets the matrix and returns the right-hand side.
  const Eigen::VectorXd& assemble(const std::vector<double>& alpha, const Constraint_vector& multipliers,
                                  const Constraint_vector& residual)
  {
    if(!m_binding) {
      m_right_hand_side = residual;
      assemble_nodes(alpha, multipliers, m_right_hand_side);
      return m_right_hand_side;
    }
    set_positions(alpha);
    m_sums_of_nodes = Eigen::VectorXd::Zero(2 * m_chart.number_of_nodes());
    assemble_nodes(alpha, of_nodes(multipliers), m_sums_of_nodes);
    m_binding->bind(m_sums_of_nodes, m_right_hand_side);
    m_right_hand_side += residual;
    m_binding->bind(m_assembly.matrix());
    return m_right_hand_side;
  }

  const Block_matrix<2>& matrix() const { return m_binding ? m_binding->matrix() : m_assembly.matrix(); }
  const Newton_equation& equation() const { return m_equation; }

private:
  typedef Small_matrix<6, 2> Plane_jacobian;

  // The data of a triangle for assembly and substitution
  struct Local_system
  {
    Vector_3 cotangents;
    Matrix_2 inverse; // (T' Lambda T)^-1
    Vector_2 force;   // T' b_1
  };

  static std::vector<int> holes_of_bound_nodes(const Chart& chart)
  {
    std::vector<int> result;
    for(int k = 0; k < chart.number_of_holes(); ++k)
      result.insert(result.end(), chart.hole(k).size(), k);
    return result;
  }

  void set_positions(const std::vector<double>& alpha)
  {
    int i = 0;
    for(const Hole_equations& hole : hole_equations(m_chart, alpha))
      for(const auto& position : hole.positions)
        m_binding->set_position(i++, position);
  }

  void set_local_systems(const std::vector<double>& alpha, const Constraint_vector& multipliers)
  {
    m_local.resize(m_chart.number_of_triangles());
    parallel_for_blocks(m_chart.number_of_triangles(), [&](int begin, int end) {
      for(int t = begin; t < end; ++t)
        m_local[t] = local_system(t, alpha, multipliers);
    });
  }

  // The multipliers of all nodes, also of those that are bound
  const Constraint_vector& of_nodes(const Constraint_vector& multipliers)
  {
    if(!m_binding)
      return multipliers;
    m_binding->expand(multipliers, m_expanded);
    return m_expanded;
  }

  // Eq. 16 for the multipliers of all nodes: sets the matrix and adds to the right-hand side.
  void assemble_nodes(const std::vector<double>& alpha, const Constraint_vector& multipliers,
                      Eigen::VectorXd& right_hand_side)
  {
    set_local_systems(alpha, multipliers);
    m_assembly.assemble([&](int c) -> Triangle_assembly<2>::Local_columns {
      const Local_system& local = m_local[c / 3];
      const Plane_jacobian jacobian = plane_jacobian(c / 3, local.cotangents);
      const Matrix_2 rows = rows_of<2>(jacobian, 2 * (c % 3));
      add_to_block(rows * (local.inverse * local.force), m_chart.node_of_corner(c), right_hand_side);
      return jacobian * transposed(rows * local.inverse);
    });
    m_loops.assemble([&](int t) -> const Local_system& { return m_local[t]; },
                     [&](int t) { return plane_jacobian(t, m_local[t].cotangents); }, m_assembly,
                     right_hand_side);
    complete_diagonal();
  }

  // J_2 T: rows 2k and 2k + 1 belong to the node of corner k. Rows without a node are unused.
  Plane_jacobian plane_jacobian(int t, const Vector_3& cotangents) const
  {
    const Sum_preserving_steps& basis = basis_of_sum_preserving_steps();
    Plane_jacobian jacobian;
    for(int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, previous = (k + 2) % 3;
      for(int j = 0; j < 2; ++j) {
        jacobian(2 * k, j) = basis(k, j);
        jacobian(2 * k + 1, j) =
            cotangents[next] * basis(next, j) - cotangents[previous] * basis(previous, j);
      }
    }
    if(!m_incomplete_nodes.empty())
      remove_absent_rows(t, jacobian);
    return jacobian;
  }

  void remove_absent_rows(int t, Plane_jacobian& jacobian) const
  {
    for(int k = 0; k < 3; ++k)
      if(const int i = m_chart.node_of_corner(3 * t + k); i >= 0) {
        for(int j = 0; j < 2; ++j) {
          jacobian(2 * k, j) *= m_chart.nodes[i].has_planarity;
          jacobian(2 * k + 1, j) *= m_chart.nodes[i].has_reconstruction;
        }
      }
  }

  // The rows and columns of missing constraints are zero. A one on the diagonal makes their multipliers 0.
  void complete_diagonal()
  {
    for(int i : m_incomplete_nodes) {
      Block_matrix<2>::Block& diagonal = m_assembly.diagonal_block(i);
      if(!m_chart.nodes[i].has_planarity)
        diagonal(0, 0) = 1;
      if(!m_chart.nodes[i].has_reconstruction)
        diagonal(1, 1) = 1;
    }
  }

  Local_system local_system(int t, const std::vector<double>& alpha,
                            const Constraint_vector& multipliers) const
  {
    Local_system local;
    local.cotangents = cotangents(alpha, t);
    Vector_3 energy_gradient, energy_curvature, curvature;
    const double weight = m_chart.weight_of_triangle(t);
    for(int k = 0; k < 3; ++k) {
      const int c = 3 * t + k;
      energy_gradient[k] = weight * m_energy.first_derivative(alpha[c], m_beta[c]);
      energy_curvature[k] = curvature[k] = weight * m_energy.second_derivative(alpha[c], m_beta[c]);
      if(m_with_constraint_curvature)
        curvature[k] += constraint_curvature(m_chart, multipliers, c, local.cotangents[k]);
    }
    local.force = -1 * transposed(basis_of_sum_preserving_steps()) * energy_gradient -
                  gradient(t, local.cotangents, multipliers);
    local.inverse = reduced_hessian_inverse(energy_curvature, curvature);
    return local;
  }

  // Eqs. 10 and 17, together.
  void substitute_back(Newton_step& step)
  {
    step.angles.resize(m_beta.size());
    const Constraint_vector& multipliers = of_nodes(step.multipliers);
    step.predicted_decrease = parallel_sum(m_chart.number_of_triangles(), [&](int t) {
      const Local_system& local = m_local[t];
      const Vector_2 force = local.force - gradient(t, local.cotangents, multipliers);
      const Vector_2 d = local.inverse * force;
      const Vector_3 angles = basis_of_sum_preserving_steps() * d;
      std::copy_n(angles.entry, 3, &step.angles[3 * t]);
      return (d[0] * force[0] + d[1] * force[1]) / 2;
    });
  }

  // The gradient of the constraints times their multipliers, in the plane of steps
  Vector_2 gradient(int t, const Vector_3& cotangents, const Constraint_vector& multipliers) const
  {
    const Plane_jacobian jacobian = plane_jacobian(t, cotangents);
    const Small_matrix<6, 1> local = gather(t, multipliers);
    Vector_2 sum;
    for(int j = 0; j < 2; ++j) {
      const auto term = [&](int i) { return jacobian(i, j) * local[i]; };
      sum[j] = (term(0) + (term(2) + term(4))) + (term(1) + (term(3) + term(5)));
    }
    if(m_chart.number_of_loops > 0)
      sum += m_loops.gradient(t, cotangents, multipliers);
    return sum;
  }

  // The six entries of a vector that belong to the vertices of triangle `t`; zero where there is no node.
  Small_matrix<6, 1> gather(int t, const Constraint_vector& vector) const
  {
    Small_matrix<6, 1> local = Small_matrix<6, 1>::zero();
    for(int k = 0; k < 3; ++k) {
      const int i = m_chart.node_of_corner(3 * t + k);
      if(i >= 0)
        std::copy_n(&vector[2 * i], 2, &local[2 * k]);
    }
    return local;
  }

  const Chart& m_chart;
  const std::vector<double>& m_beta;
  Angle_energy m_energy;
  bool m_with_constraint_curvature, m_saves_memory;
  Loop_equations m_loops;
  Triangle_assembly<2> m_assembly;
  std::vector<Local_system> m_local; // of each triangle
  std::vector<int> m_incomplete_nodes;
  std::optional<Bound_matrix> m_binding;                          // of a chart with holes
  Eigen::VectorXd m_right_hand_side, m_sums_of_nodes, m_expanded; // the last two with holes
  Newton_equation m_equation;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_NEWTON_SYSTEM_H
