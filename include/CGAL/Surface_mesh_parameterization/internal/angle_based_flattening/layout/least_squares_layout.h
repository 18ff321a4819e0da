// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From angles to coordinates in the least squares sense: Eqs. 19 to 21 of the paper. `lay_out_angles.h` falls back
// on it where angles violate their constraints too much for `exact_layout.h`, or where it is asked for.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_LEAST_SQUARES_LAYOUT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_LEAST_SQUARES_LAYOUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/triangle_assembly.h>

#include <cmath>
#include <complex>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Two border vertices that are far from one another in space.
inline std::pair<int, int> far_apart_border_vertices(const Chart& chart)
{
  const std::vector<int>& border = chart.borders.front();
  auto farthest_from = [&](int v) {
    int farthest = v;
    double distance = -1;
    for(int c : border) {
      const int w = chart.edge_source(c);
      const double d = CGAL::squared_distance(chart.points[v], chart.points[w]);
      if(w != v && d > distance) {
        distance = d;
        farthest = w;
      }
    }
    return farthest;
  };
  const int first = farthest_from(chart.edge_source(border.front()));
  return {first, farthest_from(first)};
}

// The least squares layout of the paper: Eqs. 19 to 21, with points as complex numbers. A triangle (j, k, l) asks
// for z_l - z_j = m (z_k - z_j), where m turns by the angle at j and scales by sin alpha_k / sin alpha_l.
// (The paper's matrix M turns the other way round, for its triangles are clockwise.)
class Least_squares_layout
{
  typedef std::complex<double> Complex;

public:
  Least_squares_layout(const Chart& chart, const std::vector<double>& alpha)
      : Least_squares_layout(chart, alpha, far_apart_border_vertices(chart))
  {}

  // Fixes the two vertices `pinned` at 0 and 1. (The paper takes the ends of an edge: then scale and conditioning
  // depend on that edge.)
  Least_squares_layout(const Chart& chart, const std::vector<double>& alpha, std::pair<int, int> pinned)
      : m_chart(chart), m_coefficients(alpha.size()), m_unknown(chart.points.size()), m_z(chart.points.size())
  {
    const auto [origin, unit] = pinned;
    m_z[unit] = 1;
    int n = 0;
    for(int v = 0; v < chart.number_of_vertices(); ++v)
      m_unknown[v] = v == origin || v == unit ? -1 : n++;
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      set_coefficients(3 * t, alpha);
  }

  // Solves the normal equations. Their condition is the square of the problem's: the solution is improved with the
  // residuals of Eq. 20 itself. Returns nothing if the linear solver fails.
  std::optional<std::vector<Chart::Point_2>> solve(const Linear_solvers& solvers)
  {
    const int n = m_chart.number_of_vertices() - 2;
    Triangle_assembly<2> normal_matrix(m_chart.vertex, m_unknown, n);
    normal_matrix.assemble([&](int c) -> Triangle_assembly<2>::Local_columns {
      const Small_matrix<6, 2> columns = transposed(real_row(c / 3));
      return columns * transposed(rows_of<2>(columns, 2 * (c % 3)));
    });
    const std::unique_ptr<Linear_solver> system = solvers->full_precision();
    if(!system->set_matrix(normal_matrix.matrix()))
      return std::nullopt;
    bool solved = false;
    const int refinements = 2;
    Eigen::VectorXd correction;
    for(int i = 0; i <= refinements && system->solve(minus_gradient(n), correction); ++i) {
      for(std::size_t v = 0; v < m_z.size(); ++v)
        if(const int j = m_unknown[v]; j >= 0)
          m_z[v] += Complex(correction[2 * j], correction[2 * j + 1]);
      solved = true; // an iterative solver may have nothing to improve later
    }
    if(!solved)
      return std::nullopt;
    std::vector<Chart::Point_2> uv;
    for(const Complex& z : m_z)
      uv.emplace_back(z.real(), z.imag());
    return uv;
  }

private:
  // The coefficients of Eq. 20, of the three corners. The corners are numbered so that the denominator of Eq. 19 is
  // the largest sine.
  void set_coefficients(int first, const std::vector<double>& alpha)
  {
    int l = first;
    for(int c : {first + 1, first + 2})
      if(std::sin(alpha[c]) > std::sin(alpha[l]))
        l = c;
    const int j = next_corner(l), k = previous_corner(l);
    const double scale = std::sin(alpha[k]) / std::sin(alpha[l]); // std::polar() must not get NaN
    const Complex m = scale * Complex(std::cos(alpha[j]), std::sin(alpha[j]));
    m_coefficients[j] = m - 1.;
    m_coefficients[k] = -m;
    m_coefficients[l] = 1;
  }

  Complex residual(int t) const
  {
    Complex sum = 0;
    for(int c = 3 * t; c < 3 * t + 3; ++c)
      sum += m_coefficients[c] * m_z[m_chart.vertex[c]];
    return sum;
  }

  // The complex equation of triangle `t` as two real ones.
  Small_matrix<2, 6> real_row(int t) const
  {
    Small_matrix<2, 6> row;
    for(int k = 0; k < 3; ++k) {
      const Complex a = m_coefficients[3 * t + k];
      row(0, 2 * k) = row(1, 2 * k + 1) = a.real();
      row(0, 2 * k + 1) = -a.imag();
      row(1, 2 * k) = a.imag();
    }
    return row;
  }

  // Half the negative gradient of the E_p of Eq. 21.
  Eigen::VectorXd minus_gradient(int n) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(2 * n);
    for(int t = 0; t < m_chart.number_of_triangles(); ++t) {
      const Complex r = residual(t);
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        if(const int i = m_unknown[m_chart.vertex[c]]; i >= 0) {
          const Complex g = std::conj(m_coefficients[c]) * r;
          result[2 * i] -= g.real();
          result[2 * i + 1] -= g.imag();
        }
    }
    return result;
  }

  const Chart& m_chart;
  std::vector<Complex> m_coefficients; // of each corner
  std::vector<int> m_unknown;          // of each vertex: -1 for the two that are fixed at 0 and 1
  std::vector<Complex> m_z;            // of each vertex
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_LEAST_SQUARES_LAYOUT_H
