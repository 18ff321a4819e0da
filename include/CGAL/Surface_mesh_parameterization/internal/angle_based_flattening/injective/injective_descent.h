// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Projected Newton steps that lower the energy of a map and keep it injective: no triangle turns over, the border stays
// simple. `flatten_injectively.h` runs it on coarse charts with `Area_objective`, and with `Angle_objective` to polish.
// The barrier is that of Smith and Schaefer (2015); the exact test of the border, not the barrier, makes the steps
// safe.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_INJECTIVE_DESCENT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_INJECTIVE_DESCENT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_energies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/objectives.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/planar_border.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/conjugate_gradients.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// When to stop: after a step whose expected decrease is less than this fraction of the energy of distortion, or after
// this many steps. Newton's method converges so fast that what is left after a full step is far less than what the step
// gained, so a full step may have a larger tolerance.
struct Descent_limits
{
  double tolerance = 1e-4;
  int steps = 50;
  double tolerance_of_full_step = 0;
};

// Projected Newton steps of an injective map towards the least energy, the sum of that of the triangles and the barrier
// between parts of the border. Each step stays injective: no triangle turns over, and an exact test finds the border
// simple.
//
// `Objective` knows the energy of a triangle, its derivatives, and the weight of the barrier there.
template <typename Objective>
class Injective_descent
{
  typedef std::vector<Planar_point> Positions;

  static constexpr int most_stalled_steps = 10; // after the step with the least energy

public:
  Injective_descent(const Chart& chart, const Objective& objective, double clearance,
                    const Linear_solvers& solvers)
      : m_chart(chart), m_objective(objective), m_clearance(clearance), m_solvers(solvers),
        m_factors(solvers->low_precision()), m_hessian(chart), m_barrier_weight(chart.points.size(), 0.)
  {
    std::vector<int> triangles(chart.points.size(), 0);
    for(int c = 0; c < chart.number_of_corners(); ++c)
      ++triangles[chart.vertex[c]];
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      m_least_energy += objective.least_energy(t);
    for(int c = 0; c < chart.number_of_corners(); ++c)
      m_barrier_weight[chart.vertex[c]] += objective.triangle_weight(c / 3) / triangles[chart.vertex[c]];
  }

  // Returns `false` if the linear solver fails.
  bool run(Positions& uv, const Descent_limits& limits)
  {
    m_has_converged = false;
    m_border.set(border_cycles(m_chart), uv);
    double least = (std::numeric_limits<double>::infinity)();
    int stalled_steps = 0;
    for(int step = 0; step < limits.steps; ++step) {
      Deadline::ask();
      // Ranges are fixed at the start of a step, so that the energy does not change its definition during the step. It
      // may do so between steps: where parts of the border are stuck and grow, the energy rises for ever.
      m_border.take(uv);
      const double before = energy(uv);
      if(!std::isfinite(before))
        return true;
      stalled_steps = before < least ? 0 : stalled_steps + 1;
      least = (std::min)(least, before);
      if(stalled_steps == most_stalled_steps)
        break;
      if(!find_direction(uv))
        return false;
      ++m_steps;
      const double expected = m_slope / 2, distortion = before - m_least_energy;
      m_has_converged = expected < limits.tolerance * distortion;
      const double length = search(uv, before);
      if(length == 1)
        m_has_converged = m_has_converged || expected < limits.tolerance_of_full_step * distortion;
      if(length == 0 || m_has_converged)
        break;
    }
    return true;
  }

  // Whether the last run ended because hardly any decrease is expected
  bool has_converged() const { return m_has_converged; }
  int steps() const { return m_steps; } // of all runs
  int rejections() const { return m_rejections; }

private:
  Planar_triangle corners(const Positions& uv, int t) const
  {
    return {uv[m_chart.vertex[3 * t]], uv[m_chart.vertex[3 * t + 1]], uv[m_chart.vertex[3 * t + 2]]};
  }

  // Also finds the gaps of the border.
  double energy(const Positions& uv)
  {
    const double sum = parallel_sum(m_chart.number_of_triangles(), [&](int t) {
      const Planar_triangle x = corners(uv, t);
      return cross(x[1] - x[0], x[2] - x[0]) > 0 ? m_objective.triangle_energy(t, x)
                                                 : (std::numeric_limits<double>::infinity)();
    });
    m_gaps.clear();
    if(!std::isfinite(sum))
      return sum;
    for_each_gap(m_clearance,
                 [&](const Border_pair& pair, const Border_gap& gap) { m_gaps.emplace_back(pair, gap); });
    double barrier = 0;
    for(const auto& [pair, gap] : m_gaps)
      barrier +=
          m_barrier_weight[m_border.vertex(pair.vertex)] * Barrier_function(pair.range, gap.distance).value;
    return sum + barrier;
  }

  template <typename Visitor>
  void for_each_gap(double clearance, const Visitor& visit)
  {
    const auto at = [&](int i) { return m_border.point(i); };
    for(int i = 0; i < m_border.size(); ++i) {
      m_pairs.clear();
      add_pairs_of_vertex(m_border, i, clearance, m_pairs);
      for(const Border_pair& pair : m_pairs)
        visit_gap(m_border, pair, at, [&](const Border_gap& gap) { visit(pair, gap); });
    }
  }

  Definite_hessian::Triple vertices(const Border_pair& pair) const
  {
    return {m_border.vertex(pair.vertex), m_border.vertex(pair.edge),
            m_border.vertex(m_border.next(pair.edge))};
  }

  // Makes room in the pattern for parts of the border that repel each other, and for those that soon may.
  void couple_border()
  {
    constexpr double margin = 2;
    if(m_hessian.has_pattern() && std::all_of(m_gaps.begin(), m_gaps.end(), [&](const auto& near) {
         return m_hessian.couples(vertices(near.first));
       }))
      return;
    std::vector<Definite_hessian::Triple> triples;
    for_each_gap(margin * m_clearance,
                 [&](const Border_pair& pair, const Border_gap&) { triples.push_back(vertices(pair)); });
    m_hessian.couple(triples);
  }

  // Sets the direction of Newton's method where the energy was computed last. Returns `false` if the linear solver
  // fails.
  bool find_direction(const Positions& uv)
  {
    couple_border();
    parallel_for_blocks(m_chart.number_of_triangles(), [&](int begin, int end) {
      for(int t = begin; t < end; ++t)
        m_hessian.of_triangle(t) = m_objective.triangle_derivatives(t, corners(uv, t));
    });
    m_hessian.clear_triples();
    for(const auto& [pair, gap] : m_gaps) {
      const double weight = m_barrier_weight[m_border.vertex(pair.vertex)];
      m_hessian.of_triple(vertices(pair)) = barrier_derivatives(pair, gap, weight);
    }
    m_hessian.sum_up();
    return solve();
  }

  // The energy does not change if the map is moved or turned as a whole, and hardly if it is mapped conformally. Single
  // precision needs more of the diagonal to factor such a matrix.
  bool solve()
  {
    const Iterative_accuracy accuracy = {1e-2};
    const int max_steps = 50;
    m_right_hand_side = -m_hessian.gradient();
    damp(m_hessian.matrix(), 1e-6, m_damped);
    bool done = m_solvers->keeps_factors() && m_factors->set_matrix(m_damped);
    damp(m_hessian.matrix(), 1e-8, m_damped);
    if(done) {
      m_direction = Eigen::VectorXd::Zero(m_right_hand_side.size());
      m_vectors.residual = m_right_hand_side;
      done = conjugate_gradients(m_damped, m_right_hand_side, *m_factors, accuracy, max_steps, m_vectors,
                                 m_direction)
                 .status == Iterative_solution::SOLVED;
    }
    if(!done) {
      const std::unique_ptr<Linear_solver> full = m_solvers->full_precision();
      done = full->set_matrix(m_damped) && full->solve(m_right_hand_side, m_direction);
    }
    m_slope = done ? m_direction.dot(m_right_hand_side) : 0;
    return done;
  }

  // Moves the map along the direction, as far as the energy falls and the border stays simple. Returns the fraction of
  // Newton's step that was taken, 0 if the map does not move.
  double search(Positions& uv, double before)
  {
    const int most_halvings = 30;
    m_next.resize(uv.size());
    double length = (std::min)(1., 0.9 * longest_step(uv));
    for(int i = 0; i < most_halvings; ++i, length /= 2) {
      for(std::size_t v = 0; v < uv.size(); ++v)
        m_next[v] = uv[v] + length * m_direction.segment<2>(2 * v);
      m_border.move_all(m_next);
      if(!(energy(m_next) < before))
        continue;
      if(m_border.is_simple()) {
        uv.swap(m_next);
        return length;
      }
      ++m_rejections;
    }
    return 0;
  }

  // How far one may go along the direction until a triangle degenerates
  double longest_step(const Positions& uv) const
  {
    double longest = (std::numeric_limits<double>::infinity)();
    for(int t = 0; t < m_chart.number_of_triangles(); ++t) {
      const Planar_triangle x = corners(uv, t);
      Planar_triangle d;
      for(int k = 0; k < 3; ++k)
        d[k] = m_direction.segment<2>(2 * m_chart.vertex[3 * t + k]);
      const Planar_point e = x[1] - x[0], f = x[2] - x[0], de = d[1] - d[0], df = d[2] - d[0];
      longest =
          (std::min)(longest, least_positive_root(cross(de, df), cross(e, df) + cross(de, f), cross(e, f)));
    }
    return longest;
  }

  // Of a t^2 + b t + c with c > 0, or infinity
  static double least_positive_root(double a, double b, double c)
  {
    const double infinity = (std::numeric_limits<double>::infinity)(), discriminant = b * b - 4 * a * c;
    if(discriminant < 0 || (b >= 0 && a >= 0))
      return infinity;
    const double q = b < 0 ? -b + std::sqrt(discriminant) : 0;
    const double root = b < 0 ? 2 * c / q : (-b - std::sqrt(discriminant)) / (2 * a);
    return root > 0 ? root : infinity;
  }

  const Chart& m_chart;
  const Objective& m_objective;
  double m_clearance;
  Linear_solvers m_solvers;
  std::unique_ptr<Linear_solver>
      m_factors; // knows the pattern as long as no other parts of the border come near
  Planar_border m_border;
  Definite_hessian m_hessian;
  Block_matrix<2> m_damped;
  Iteration_vectors m_vectors;
  Positions m_next;
  std::vector<std::pair<Border_pair, Border_gap>> m_gaps; // where the energy was computed last
  std::vector<Border_pair> m_pairs;                       // near one vertex
  std::vector<double> m_barrier_weight;                   // of each vertex
  Eigen::VectorXd m_right_hand_side, m_direction;
  double m_least_energy = 0; // without any distortion
  bool m_has_converged = false;
  int m_steps = 0, m_rejections = 0;
  double m_slope = 0; // of the energy along the direction, downwards
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_INJECTIVE_DESCENT_H
