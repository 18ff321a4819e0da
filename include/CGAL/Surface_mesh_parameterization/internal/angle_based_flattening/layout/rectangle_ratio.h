// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The ratio of the sides of a conformal rectangle with given corners. `rectangle_corners_impl.h` searches among these.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_RATIO_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_RATIO_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Four ranks in the outer border, in ascending order but for a rotation
typedef std::array<int, 4> Rectangle_ranks;

// Harmonic functions on a chart with values at some vertices
class Harmonic_functions
{
public:
  typedef std::vector<std::optional<double>> Values;

  Harmonic_functions(const Chart& chart, const Linear_solvers& solvers)
      : m_chart(chart), m_solvers(solvers), m_weights(cotangents(starting_angles(target_angles(chart))))
  {}

  std::size_t number_of_vertices() const { return m_chart.points.size(); }
  int border_size() const { return static_cast<int>(m_chart.borders.front().size()); }

  int border_vertex(int rank) const
  {
    return m_chart.edge_source(m_chart.borders.front()[rank % border_size()]);
  }

  // Sets the values that `u` does not have, with a current that comes in at a vertex without a value, or without one if
  // `inlet` is -1. Returns false if the linear solver fails.
  bool solve(Values& u, int inlet) const
  {
    std::vector<int> unknown(u.size(), -1);
    int n = 0;
    for(std::size_t v = 0; v < u.size(); ++v)
      if(!u[v])
        unknown[v] = n++;
    if(n == 0)
      return true;
    Eigen::VectorXd source = Eigen::VectorXd::Zero(n), solution;
    if(inlet >= 0)
      source[unknown[inlet]] = 2; // the matrix has twice the usual weights
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      for(const auto& [v, w] : {std::pair(m_chart.edge_source(c), m_chart.edge_target(c)),
                                std::pair(m_chart.edge_target(c), m_chart.edge_source(c))})
        if(unknown[v] >= 0 && u[w])
          source[unknown[v]] += m_weights[c] * *u[w];
    const std::unique_ptr<Linear_solver> solver = m_solvers->full_precision();
    if(!solver->set_matrix(cotangent_laplacian(m_chart, m_weights, unknown, n).matrix()) ||
       !solver->solve(source, solution))
      return false;
    for(std::size_t v = 0; v < u.size(); ++v)
      if(unknown[v] >= 0)
        u[v] = solution[unknown[v]];
    return true;
  }

  // The ratio of the sides of a rectangle, from the Dirichlet energies of the functions that are 1 on a side and 0 on
  // the opposite one. On a mesh, these are above those of the surface. Of the two pairs of sides, one gives the ratio
  // and the other its inverse: the geometric mean removes most of that. Returns nothing if the linear solver fails.
  std::optional<double> ratio(const Rectangle_ranks& corners) const
  {
    const auto width = energy(corners, 0), height = energy(corners, 1);
    return width && height ? std::optional(std::sqrt(*width / *height)) : std::nullopt;
  }

private:
  std::optional<double> energy(const Rectangle_ranks& corners, int side) const
  {
    Values u(m_chart.points.size());
    for(const auto& [first, value] : {std::pair(side, 1.), std::pair(side + 2, 0.)}) {
      const int last = corners[(first + 1) % 4];
      for(int i = corners[first]; i % border_size() != last; ++i)
        u[border_vertex(i)] = value;
      u[border_vertex(last)] = value;
    }
    if(!solve(u, -1))
      return std::nullopt;
    double sum = 0;
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      sum += m_weights[c] * square(*u[m_chart.edge_source(c)] - *u[m_chart.edge_target(c)]) / 2;
    return sum;
  }

  const Chart& m_chart;
  const Linear_solvers m_solvers;
  const std::vector<double> m_weights;
};

// Estimates the ratios of all rectangles from one harmonic function.
//
// Let u be the potential of a current that flows from one border vertex to another. It maps the surface conformally to
// a strip, and exp(pi u) maps the strip to a half-plane: to the positive numbers on one side of the border, and to the
// negative ones on the other. A conformal rectangle is determined by the cross-ratio of its corners there (L. V.
// Ahlfors, Conformal Invariants, Section 4-6). On coarse meshes, the ratio is wrong by some hundredths.
class Ratio_estimate
{
public:
  // Returns nothing if the linear solver fails.
  static std::optional<Ratio_estimate> make(const Harmonic_functions& harmonic, int outlet)
  {
    Harmonic_functions::Values u(harmonic.number_of_vertices());
    u[harmonic.border_vertex(outlet)] = 0;
    if(!harmonic.solve(u, harmonic.border_vertex(0)))
      return std::nullopt;
    std::vector<double> potential;
    for(int i = 0; i < harmonic.border_size(); ++i)
      potential.push_back(*u[harmonic.border_vertex(i)]);
    return Ratio_estimate(std::move(potential), outlet);
  }

  // The length of the side from the first corner to the second one, divided by that of the next side: the quotient of
  // two elliptic integrals, by arithmetic-geometric means
  double operator()(const Rectangle_ranks& c) const
  {
    const double difference = log_distance(c[0], c[1]) + log_distance(c[2], c[3]) - log_distance(c[1], c[2]) -
                              log_distance(c[3], c[0]);
    const auto mean = [](double exponent) {
      double x = 1, y = std::sqrt(1 / (1 + std::exp(exponent)));
      for(int i = 0; i < 40 && x - y > 1e-15 * x; ++i)
        std::tie(x, y) = std::pair((x + y) / 2, std::sqrt(x * y));
      return x;
    };
    return mean(-difference) / mean(difference);
  }

  // How coarse the border is at the corners, by cross-ratios with their neighbours. Angles change the more there, the
  // larger it is.
  double coarseness(const Rectangle_ranks& c) const
  {
    const int size = static_cast<int>(m_potential.size());
    double sum = 0;
    for(int i = 0; i < 4; ++i) {
      const int previous = c[(i + 3) % 4], next = c[(i + 1) % 4], before = (c[i] + size - 1) % size,
                after = (c[i] + 1) % size;
      sum += before == previous || after == next
                 ? 1
                 : std::exp(log_distance(before, after) + log_distance(previous, next) -
                            log_distance(previous, before) - log_distance(after, next));
    }
    return sum;
  }

private:
  Ratio_estimate(std::vector<double> potential, int outlet)
      : m_potential(std::move(potential)), m_outlet(outlet)
  {}

  // The distance of two vertices of the border, up to a factor for each of them, which cross-ratios do not have
  double log_distance(int i, int j) const
  {
    const double x = (std::max)(CGAL_PI * std::abs(m_potential[i] - m_potential[j]), 1e-300);
    return x / 2 + ((i < m_outlet) == (j < m_outlet) ? std::log(-std::expm1(-x)) : std::log1p(std::exp(-x)));
  }

  std::vector<double> m_potential; // of each vertex of the outer border
  int m_outlet;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_RATIO_H
