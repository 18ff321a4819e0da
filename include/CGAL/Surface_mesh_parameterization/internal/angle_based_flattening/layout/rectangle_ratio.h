// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The ratio of the sides of a conformal rectangle with given corners, which is a Dirichlet energy; and candidates for
// the corners. `rectangle_corners_impl.h` searches among these.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_RATIO_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_RATIO_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Predicts the ratio of the sides of a rectangle from its corners.
class Rectangle_ratio
{
public:
  Rectangle_ratio(const Chart& chart, const Linear_solvers& solvers)
      : m_chart(chart), m_solvers(solvers), m_cotangents(cotangents(starting_angles(target_angles(chart))))
  {}

  // `corner` are ascending ranks in the outer border. On a mesh, the energy of a harmonic function is above that of the
  // surface. Of the two pairs of sides, one gives the ratio and the other its inverse: the geometric mean removes
  // most of that. Returns nothing if the linear solver fails.
  std::optional<double> operator()(const std::array<int, 4>& corner) const
  {
    const int size = static_cast<int>(m_chart.borders.front().size());
    const auto height = energy({corner[1], corner[2]}, {corner[3], size});
    const auto width = height ? energy({corner[0], corner[1]}, {corner[2], corner[3]}) : std::nullopt;
    return width ? std::optional<double>(std::sqrt(*width / *height)) : std::nullopt;
  }

private:
  // The ranks of the ends; that of the first vertex may also be the size of the border.
  typedef std::pair<int, int> Side;

  void set(const Side& side, double value, std::vector<double>& u) const
  {
    const std::vector<int>& border = m_chart.borders.front();
    for(int i = side.first; i <= side.second; ++i)
      u[m_chart.edge_source(border[i % border.size()])] = value;
  }

  // The Dirichlet energy of the harmonic function that is 1 on a side and 0 on the other, and free elsewhere
  std::optional<double> energy(const Side& one, const Side& zero) const
  {
    std::vector<double> u(m_chart.points.size(), -1);
    set(one, 1, u);
    set(zero, 0, u);
    int n = 0;
    std::vector<int> unknown(u.size(), -1);
    for(std::size_t v = 0; v < u.size(); ++v)
      if(u[v] < 0)
        unknown[v] = n++;
    if(n > 0 && !solve(unknown, n, u))
      return std::nullopt;
    double sum = 0;
    for(int c = 0; c < m_chart.number_of_corners(); ++c) {
      const double difference = u[m_chart.edge_source(c)] - u[m_chart.edge_target(c)];
      sum += m_cotangents[c] * difference * difference / 2;
    }
    return sum > 0 ? std::optional<double>(sum) : std::nullopt;
  }

  bool solve(const std::vector<int>& unknown, int n, std::vector<double>& u) const
  {
    Eigen::VectorXd source = Eigen::VectorXd::Zero(n), solution;
    for(int c = 0; c < m_chart.number_of_corners(); ++c) {
      const int v = m_chart.edge_source(c), w = m_chart.edge_target(c);
      if(unknown[v] >= 0 && unknown[w] < 0)
        source[unknown[v]] += m_cotangents[c] * u[w];
      if(unknown[w] >= 0 && unknown[v] < 0)
        source[unknown[w]] += m_cotangents[c] * u[v];
    }
    const std::unique_ptr<Linear_solver> solver = m_solvers->full_precision();
    if(!solver->set_matrix(cotangent_laplacian(m_chart, m_cotangents, unknown, n).matrix()) ||
       !solver->solve(source, solution))
      return false;
    for(std::size_t v = 0; v < u.size(); ++v)
      if(unknown[v] >= 0)
        u[v] = solution[unknown[v]];
    return true;
  }

  const Chart& m_chart;
  const Linear_solvers m_solvers;
  const std::vector<double> m_cotangents;
};

// Rectangles from the lowest one to the widest one, each with a corner moved by one vertex. The first corner and the
// third, half the length of the border apart, stay where they are.
class Rectangle_family
{
public:
  explicit Rectangle_family(const Chart& chart)
  {
    const std::vector<int>& border = chart.borders.front();
    const int size = static_cast<int>(border.size());
    std::vector<double> arc{0}; // edges without length have a little, so that there is nothing to divide by 0
    for(int c : border)
      arc.push_back(arc.back() + edge_length(chart, c) + 1e-9);
    const double half = arc.back() / 2;
    int third = static_cast<int>(std::lower_bound(arc.begin(), arc.end(), half) - arc.begin());
    if(half - arc[third - 1] < arc[third] - half)
      --third;
    third = (std::min)((std::max)(third, 2), size - 2);
    // Both corners arrive at the ends of their parts of the border at the same time.
    std::vector<std::pair<double, int>> moves;
    for(int i = 2; i < third; ++i)
      moves.emplace_back(arc[i] / arc[third], 1);
    for(int i = third + 2; i < size; ++i)
      moves.emplace_back((arc[i] - arc[third]) / (arc[size] - arc[third]), 3);
    std::sort(moves.begin(), moves.end());
    m_corners.push_back({0, 1, third, third + 1});
    for(const auto& [time, corner] : moves) {
      m_corners.push_back(m_corners.back());
      ++m_corners.back()[corner];
    }
  }

  int size() const { return static_cast<int>(m_corners.size()); }
  const std::array<int, 4>& operator[](int i) const { return m_corners[i]; }

private:
  std::vector<std::array<int, 4>> m_corners; // ranks in the border
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_RATIO_H
