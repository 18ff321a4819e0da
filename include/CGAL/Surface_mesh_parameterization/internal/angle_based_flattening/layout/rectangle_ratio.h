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

// Harmonic functions with values at some vertices of the outer border. The matrix has twice the usual weights.
class Harmonic_functions
{
public:
  Harmonic_functions(const Chart& chart, const Linear_solvers& solvers)
      : m_chart(chart), m_solvers(solvers), m_weights(cotangents(starting_angles(target_angles(chart))))
  {}

  // Sets the values that `u` does not have, with a current that flows into the first vertex of the border and out where
  // values are given. Returns false if the linear solver fails.
  bool solve(std::vector<std::optional<double>>& u, double current) const
  {
    std::vector<int> unknown(u.size(), -1);
    int n = 0;
    for(std::size_t v = 0; v < u.size(); ++v)
      if(!u[v])
        unknown[v] = n++;
    if(n == 0)
      return true;
    Eigen::VectorXd source = Eigen::VectorXd::Zero(n), solution;
    if(current > 0)
      source[unknown[m_chart.edge_source(m_chart.borders.front().front())]] = 2 * current;
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

  // The Dirichlet energy of the function that is 1 between two ranks of the border, and 0 between two others
  std::optional<double> energy(std::pair<int, int> one, std::pair<int, int> zero) const
  {
    std::vector<std::optional<double>> u(m_chart.points.size());
    for(const auto& [side, value] : {std::pair(one, 1.), std::pair(zero, 0.)})
      for(int i = side.first; i <= side.second; ++i)
        u[border_vertex(i)] = value;
    if(!solve(u, 0))
      return std::nullopt;
    double sum = 0;
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      sum += m_weights[c] * square(*u[m_chart.edge_source(c)] - *u[m_chart.edge_target(c)]) / 2;
    return sum;
  }

  int border_vertex(int rank) const
  {
    const std::vector<int>& border = m_chart.borders.front();
    return m_chart.edge_source(border[rank % border.size()]);
  }

private:
  const Chart& m_chart;
  const Linear_solvers m_solvers;
  const std::vector<double> m_weights;
};

// Predicts ratios of sides of rectangles, from three linear systems.
//
// Let u be the potential of a current that flows from one border vertex to another. It maps the surface conformally to
// a strip, and exp(pi u) maps the strip to a half-plane: to the positive numbers on one side of the border, and to the
// negative ones on the other. A conformal rectangle is determined by the cross-ratio of its corners there (L. V.
// Ahlfors, Conformal Invariants, Section 4-6). Where the border is coarse, this is much nearer to the ratio in the
// plane than potentials between the sides of the rectangle, which have singularities at its corners.
//
// On a mesh, the conductance is above that of the surface. For the two pairs of sides of a rectangle, the product of
// both conductances is 1 on the surface, and says by how much.
class Rectangle_ratio
{
public:
  // Ranks in the outer border, in ascending order but for a rotation
  typedef std::array<int, 4> Corners;

  // `quarters` starts with 0, and divides the border into parts that are long enough for a rectangle. Returns nothing if
  // the linear solver fails.
  static std::optional<Rectangle_ratio> make(const Chart& chart, const Corners& quarters,
                                             const Linear_solvers& solvers)
  {
    const int size = static_cast<int>(chart.borders.front().size());
    const Harmonic_functions harmonic(chart, solvers);
    std::vector<std::optional<double>> potential(chart.points.size());
    potential[harmonic.border_vertex(quarters[2])] = 0;
    if(!harmonic.solve(potential, 1))
      return std::nullopt;
    const auto width = harmonic.energy({0, quarters[1]}, {quarters[2], quarters[3]}),
               height = harmonic.energy({quarters[1], quarters[2]}, {quarters[3], size});
    if(!width || !height)
      return std::nullopt;
    const double excess = std::sqrt((std::max)(*width * *height, 1.));
    std::vector<double> of_border;
    for(int i = 0; i < size; ++i)
      of_border.push_back(*potential[harmonic.border_vertex(i)] * excess);
    return Rectangle_ratio(std::move(of_border), quarters[2]);
  }

  // The length of the side from the first corner to the second one, divided by that of the next side: the quotient of
  // two elliptic integrals, by arithmetic-geometric means
  double operator()(const Corners& c) const
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

  // How coarse the border is at a corner between two others, by the cross-ratio with its neighbours. Angles change the
  // more there, the larger it is.
  double coarseness(int previous, int corner, int next) const
  {
    const int size = static_cast<int>(m_potential.size()), before = (corner + size - 1) % size,
              after = (corner + 1) % size;
    if(before == previous || after == next)
      return 1;
    return std::exp(log_distance(before, after) + log_distance(previous, next) -
                    log_distance(previous, before) - log_distance(after, next));
  }

private:
  Rectangle_ratio(std::vector<double> potential, int sink) : m_potential(std::move(potential)), m_sink(sink)
  {}

  // The distance of two vertices of the border, up to a factor for each of them, which cross-ratios do not have
  double log_distance(int i, int j) const
  {
    const double x = (std::max)(CGAL_PI * std::abs(m_potential[i] - m_potential[j]), 1e-300);
    return x / 2 + ((i < m_sink) == (j < m_sink) ? std::log(-std::expm1(-x)) : std::log1p(std::exp(-x)));
  }

  std::vector<double> m_potential; // of each vertex of the outer border
  int m_sink;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_RATIO_H
