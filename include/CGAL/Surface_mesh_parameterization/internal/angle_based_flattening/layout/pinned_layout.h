// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Moves a valid map so that some vertices come to given positions: by a similarity, and by the least squares layout of
// its own angles. `strategies/pin_map.h` applies it to finished maps of all methods. The angles of the map stand in
// place of those of Eq. 20.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PINNED_LAYOUT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PINNED_LAYOUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

typedef std::complex<double> Complex;

inline std::vector<Complex> complex_numbers(const std::vector<Chart::Point_2>& points)
{
  std::vector<Complex> z;
  z.reserve(points.size());
  for(const Chart::Point_2& p : points)
    z.emplace_back(p.x(), p.y());
  return z;
}

// Turns, scales and moves the plane.
struct Complex_similarity
{
  Complex factor = 1, from = 0, to = 0;

  Complex operator()(const Complex& z) const { return factor * (z - from) + to; }
  Complex inverse(const Complex& z) const { return (z - to) / factor + from; }
};

// Which similarity takes points nearest to their positions, and whether a mirrored one would come nearer. One point
// only moves the plane, and two are met.
struct Fit
{
  Complex_similarity similarity;
  bool is_mirrored = false;
};

inline Fit fit_similarity(const std::vector<Complex>& points, const std::vector<Complex>& positions)
{
  Fit fit;
  const double n = static_cast<double>(points.size());
  double size = 0, position_size = 0; // squares of coordinates may be out of the range of numbers
  for(std::size_t i = 0; i < points.size(); ++i) {
    fit.similarity.from += points[i] / n;
    fit.similarity.to += positions[i] / n;
  }
  for(std::size_t i = 0; i < points.size(); ++i) {
    size = (std::max)(size, std::abs(points[i] - fit.similarity.from));
    position_size = (std::max)(position_size, std::abs(positions[i] - fit.similarity.to));
  }
  if(points.size() < 2)
    return fit;
  double squares = 0, position_squares = 0;
  Complex turn = 0, mirrored_turn = 0;
  for(std::size_t i = 0; i < points.size(); ++i) {
    const Complex p = (points[i] - fit.similarity.from) / size,
                  q = (positions[i] - fit.similarity.to) / position_size;
    squares += std::norm(p);
    position_squares += std::norm(q);
    turn += q * std::conj(p);
    mirrored_turn += q * p;
  }
  fit.is_mirrored = std::abs(mirrored_turn) > (1 + 1e-9) * std::abs(turn); // equal if they are on a line
  const Complex direction = std::abs(turn) > 0 ? turn / std::abs(turn) : Complex(1);
  fit.similarity.factor = position_size / size * std::sqrt(position_squares / squares) * direction;
  return fit;
}

// The map f of a planar triangulation onto another one that minimizes
//   int |df/d conj(z)|^2
//   + stiffness * area * sum over edges of |jump of df/dz|^2 * length^2 * 3 / (area of both triangles)
// with some vertices at given positions, or drawn to them by weights. The first term is the change of angles, and the
// least squares of Eq. 20 with weights that do not depend on the mesh. By itself, it lets pins move alone on fine
// meshes, and their triangles flip; the second one spreads the change. Both vanish for similarities only.
class Pinned_layout
{
  // A complex linear function of the positions of three or four vertices
  struct Term
  {
    std::array<int, 4> vertex;
    std::array<Complex, 4> coefficient;
    int size;
  };

public:
  // `z` is a valid map. With an infinite weight, pins are exactly at their positions.
  Pinned_layout(const Chart& chart, std::vector<Complex> z, double stiffness, double weight)
      : m_chart(chart), m_z(std::move(z)), m_weight(m_z.size(), 0.), m_unknown(m_z.size(), 0)
  {
    const bool is_exact = std::isinf(weight);
    for(const Chart::Pin& pin : chart.pins) {
      m_weight[pin.vertex] = is_exact ? 0 : weight / static_cast<double>(chart.pins.size());
      m_unknown[pin.vertex] = is_exact ? -1 : 0;
    }
    for(int& unknown : m_unknown)
      if(unknown == 0)
        unknown = m_size++;
    find_terms(stiffness);
    find_terms_of_vertices();
  }

  // The positions of the pins are in the plane of the given map. Returns nothing if the linear solver fails.
  std::optional<std::vector<Complex>> solve(const std::vector<Complex>& positions,
                                            const Linear_solvers& solvers)
  {
    m_position.assign(m_z.size(), 0);
    for(std::size_t i = 0; i < positions.size(); ++i) {
      const int v = m_chart.pins[i].vertex;
      m_position[v] = positions[i];
      if(m_unknown[v] < 0)
        m_z[v] = positions[i];
    }
    const std::unique_ptr<Linear_solver> system = solvers->full_precision();
    if(m_size > 0 && !system->set_matrix(matrix()))
      return std::nullopt;
    const int refinements = 2;
    Eigen::VectorXd correction;
    for(int i = 0; m_size > 0 && i <= refinements; ++i) {
      if(!system->solve(minus_gradient(), correction)) {
        if(i == 0)
          return std::nullopt;
        break; // an iterative solver may have nothing to improve
      }
      for(std::size_t v = 0; v < m_z.size(); ++v)
        if(const int j = m_unknown[v]; j >= 0)
          m_z[v] += Complex(correction[2 * j], correction[2 * j + 1]);
    }
    return m_z;
  }

private:
  Complex edge(int c) const { return m_z[m_chart.edge_target(c)] - m_z[m_chart.edge_source(c)]; }

  // Rounding must not make the area of a sliver zero.
  double area(int t) const
  {
    const Complex e = edge(3 * t), f = edge(3 * t + 1), g = edge(3 * t + 2);
    const double longest = (std::max)({std::norm(e), std::norm(f), std::norm(g)});
    return (std::max)((std::conj(e) * f).imag() / 2, 1e-14 * longest);
  }

  void find_terms(double stiffness)
  {
    std::vector<double> areas;
    double total = 0;
    for(int t = 0; t < m_chart.number_of_triangles(); ++t) {
      areas.push_back(area(t));
      total += areas.back();
      Term term{{-1, -1, -1, -1}, {}, 3};
      for(int k = 0; k < 3; ++k) {
        term.vertex[k] = m_chart.vertex[3 * t + k];
        term.coefficient[k] = edge(3 * t + k) / (4 * std::sqrt(areas[t]));
      }
      m_terms.push_back(term);
    }
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      if(const int across = m_chart.opposite[c]; across > c)
        m_terms.push_back(jump(c, across, areas, std::sqrt(stiffness * total)));
  }

  // The jump of df/dz across the edge that both corners face
  Term jump(int c, int across, const std::vector<double>& areas, double factor) const
  {
    const double s = areas[c / 3], t = areas[across / 3];
    const double weight = factor * std::sqrt(3 / (s + t)) * std::abs(edge(c));
    const auto derivative = [&](int corner, double area) {
      return Complex(0, -weight / (4 * area)) * std::conj(edge(corner));
    };
    return {{m_chart.vertex[c], m_chart.vertex[across], m_chart.edge_source(c), m_chart.edge_target(c)},
            {derivative(c, s), -derivative(across, t),
             derivative(next_corner(c), s) - derivative(previous_corner(across), t),
             derivative(previous_corner(c), s) - derivative(next_corner(across), t)},
            4};
  }

  void find_terms_of_vertices()
  {
    m_terms_of.resize(m_z.size());
    for(std::size_t i = 0; i < m_terms.size(); ++i)
      for(int k = 0; k < m_terms[i].size; ++k)
        m_terms_of[m_terms[i].vertex[k]].push_back(static_cast<int>(i));
  }

  Complex value(const Term& term) const
  {
    Complex sum = 0;
    for(int k = 0; k < term.size; ++k)
      sum += term.coefficient[k] * m_z[term.vertex[k]];
    return sum;
  }

  // Half the second derivative: a Hermitian matrix, whose numbers are blocks of two rows and columns
  Block_matrix<2> matrix() const
  {
    Block_matrix<2> matrix;
    std::vector<std::pair<int, Complex>> column;
    for(std::size_t v = 0; v < m_z.size(); ++v) {
      if(m_unknown[v] < 0)
        continue;
      column.assign(1, {m_unknown[v], m_weight[v]});
      for(int i : m_terms_of[v])
        add_to_column(m_terms[i], static_cast<int>(v), column);
      std::stable_sort(column.begin(), column.end(),
                       [](const auto& a, const auto& b) { return a.first < b.first; });
      append(column, matrix);
    }
    return matrix;
  }

  void add_to_column(const Term& term, int v, std::vector<std::pair<int, Complex>>& column) const
  {
    const auto at_v = std::find(term.vertex.begin(), term.vertex.end(), v) - term.vertex.begin();
    for(int k = 0; k < term.size; ++k)
      if(const int row = m_unknown[term.vertex[k]]; row >= 0)
        column.emplace_back(row, std::conj(term.coefficient[k]) * term.coefficient[at_v]);
  }

  static void append(const std::vector<std::pair<int, Complex>>& column, Block_matrix<2>& matrix)
  {
    for(std::size_t i = 0; i < column.size();) {
      const int row = column[i].first;
      Complex sum = 0;
      for(; i < column.size() && column[i].first == row; ++i)
        sum += column[i].second;
      matrix.row.push_back(row);
      matrix.block.push_back({{sum.real(), sum.imag(), -sum.imag(), sum.real()}});
    }
    matrix.begin.push_back(static_cast<int>(matrix.row.size()));
  }

  Eigen::VectorXd minus_gradient() const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(2 * m_size);
    const auto add = [&](int v, const Complex& gradient) {
      if(const int i = m_unknown[v]; i >= 0) {
        result[2 * i] -= gradient.real();
        result[2 * i + 1] -= gradient.imag();
      }
    };
    for(const Term& term : m_terms) {
      const Complex residual = value(term);
      for(int k = 0; k < term.size; ++k)
        add(term.vertex[k], std::conj(term.coefficient[k]) * residual);
    }
    for(const Chart::Pin& pin : m_chart.pins)
      add(pin.vertex, m_weight[pin.vertex] * (m_z[pin.vertex] - m_position[pin.vertex]));
    return result;
  }

  const Chart& m_chart;
  std::vector<Complex> m_z;        // of each vertex
  std::vector<Complex> m_position; // of each vertex: where it is pinned
  std::vector<double> m_weight;    // of each vertex: how much it is drawn to its position
  std::vector<int> m_unknown;      // of each vertex: -1 where it is exactly at its position
  int m_size = 0;                  // number of unknowns
  std::vector<Term> m_terms;
  std::vector<std::vector<int>> m_terms_of; // at each vertex
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_PINNED_LAYOUT_H
