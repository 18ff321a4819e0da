// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_LAGRANGIAN_H
#define ABF_BENCHMARK_LAGRANGIAN_H

#include "chart_method.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ABF_benchmark {

typedef Eigen::VectorXd Vector;
typedef Eigen::SparseMatrix<double> Matrix;

// The form of the reconstruction constraint, by which the two products of sines around a vertex are equal.
enum Reconstruction_form
{
  PRODUCTS,  // their difference vanishes (Eq. 4)
  LOGARITHMS // the difference of their logarithms vanishes (Zayer et al.)
};

// The augmented objective F of Section 2.2, of all 4 n_f + 2 n_int unknowns x: the angles of all corners, then the
// multipliers of the triangles, then of each interior vertex that of planarity and that of reconstruction.
class Lagrangian
{
public:
  Lagrangian(const Chart& chart, Reconstruction_form form)
      : m_chart(chart), m_form(form), m_corners(chart.number_of_interior_vertices)
  {
    const std::vector<double> beta = abf::target_angles(chart);
    m_beta = Eigen::Map<const Vector>(beta.data(), beta.size());
    for(int c = 0; c < chart.number_of_corners(); ++c)
      if(const int i = chart.interior[chart.vertex[c]]; i >= 0)
        m_corners[i].push_back(c);
  }

  int number_of_angles() const { return m_chart.number_of_corners(); }
  int number_of_constraints() const
  {
    return m_chart.number_of_triangles() + 2 * m_chart.number_of_interior_vertices;
  }

  // The optimal angles, and no multipliers.
  Vector start() const
  {
    Vector x = Vector::Zero(number_of_angles() + number_of_constraints());
    x.head(number_of_angles()) = m_beta;
    return x;
  }

  // The diagonal of Eq. 6. The energy has no other second derivatives.
  Vector energy_curvature() const { return 2 * m_beta.array().square().inverse(); }

  Vector constraints(const Vector& x) const
  {
    const int n_f = m_chart.number_of_triangles();
    Vector values = Vector::Zero(number_of_constraints());
    for(int t = 0; t < n_f; ++t)
      values[t] = x.segment<3>(3 * t).sum() - abf::pi;
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const Wheel wheel(*this, i, x);
      values[n_f + 2 * i] = wheel.sum - 2 * abf::pi;
      values[n_f + 2 * i + 1] =
          m_form == PRODUCTS ? wheel.next - wheel.previous : std::log(wheel.next / wheel.previous);
    }
    return values;
  }

  // J of Eq. 11.
  Matrix jacobian(const Vector& x) const
  {
    const int n_f = m_chart.number_of_triangles();
    std::vector<Eigen::Triplet<double>> entries;
    for(int c = 0; c < number_of_angles(); ++c)
      entries.emplace_back(c / 3, c, 1);
    for(std::size_t i = 0; i < m_corners.size(); ++i) {
      const int row = n_f + 2 * static_cast<int>(i);
      const Wheel wheel(*this, i, x);
      for(int c : m_corners[i]) {
        const int next = abf::next_corner(c), previous = abf::previous_corner(c);
        entries.emplace_back(row, c, 1);
        entries.emplace_back(row + 1, next, wheel.next_weight() / std::tan(x[next]));
        entries.emplace_back(row + 1, previous, -wheel.previous_weight() / std::tan(x[previous]));
      }
    }
    Matrix result(number_of_constraints(), number_of_angles());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  Vector gradient(const Vector& x) const
  {
    Vector result(x.size());
    result << energy_curvature().cwiseProduct(x.head(number_of_angles()) - m_beta) +
                  jacobian(x).transpose() * x.tail(number_of_constraints()),
        constraints(x);
    return result;
  }

  // The second derivatives of F, of order 4 n_f + 2 n_int.
  Matrix hessian(const Vector& x) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    const Vector curvature = energy_curvature();
    for(int c = 0; c < number_of_angles(); ++c)
      entries.emplace_back(c, c, curvature[c]);
    for(std::size_t i = 0; i < m_corners.size(); ++i)
      add_reconstruction_curvature(i, x, entries);
    const Matrix j = jacobian(x);
    for(int column = 0; column < j.outerSize(); ++column)
      for(Matrix::InnerIterator entry(j, column); entry; ++entry) {
        const int row = number_of_angles() + static_cast<int>(entry.row());
        entries.emplace_back(row, column, entry.value());
        entries.emplace_back(column, row, entry.value());
      }
    Matrix result(x.size(), x.size());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  std::vector<double> angles(const Vector& x) const { return {x.data(), x.data() + number_of_angles()}; }

  // The largest violation of a constraint. Reconstruction is measured in logarithms for all methods. Angles out of
  // (0, pi) violate them without bound.
  double residual(const Vector& x) const
  {
    const auto alpha = x.head(number_of_angles());
    if(!(alpha.minCoeff() > 0 && alpha.maxCoeff() < abf::pi))
      return std::numeric_limits<double>::infinity();
    return (std::max)(constraints(x).head(m_chart.number_of_triangles()).lpNorm<Eigen::Infinity>(),
                      abf::constraint_residuals(m_chart, angles(x)).lpNorm<Eigen::Infinity>());
  }

private:
  // The sum of the angles at an interior vertex, and the products of the sines of the next and the previous angles.
  struct Wheel
  {
    double sum = 0, next = 1, previous = 1;
    Reconstruction_form form;

    Wheel(const Lagrangian& lagrangian, std::size_t i, const Vector& x) : form(lagrangian.m_form)
    {
      for(int c : lagrangian.m_corners[i]) {
        sum += x[c];
        next *= std::sin(x[abf::next_corner(c)]);
        previous *= std::sin(x[abf::previous_corner(c)]);
      }
    }

    // The factor of the cotangents in the derivatives.
    double next_weight() const { return form == PRODUCTS ? next : 1; }
    double previous_weight() const { return form == PRODUCTS ? previous : 1; }
  };

  // A product of sines has the second derivatives -product, and product cot a cot b for two different angles; a
  // logarithm of a sine has -1 / sin^2.
  void add_reconstruction_curvature(std::size_t i, const Vector& x,
                                    std::vector<Eigen::Triplet<double>>& entries) const
  {
    const double multiplier = x[number_of_angles() + m_chart.number_of_triangles() + 2 * i + 1];
    const Wheel wheel(*this, i, x);
    auto add = [&](int (*neighbour)(int), double factor) {
      for(int c : m_corners[i]) {
        const int a = neighbour(c);
        const double sine = std::sin(x[a]);
        entries.emplace_back(a, a, m_form == PRODUCTS ? -factor : -factor / (sine * sine));
        if(m_form == PRODUCTS)
          for(int d : m_corners[i])
            if(const int b = neighbour(d); b != a)
              entries.emplace_back(a, b, factor / (std::tan(x[a]) * std::tan(x[b])));
      }
    };
    add(abf::next_corner, multiplier * wheel.next_weight());
    add(abf::previous_corner, -multiplier * wheel.previous_weight());
  }

  const Chart& m_chart;
  Reconstruction_form m_form;
  Vector m_beta;
  std::vector<std::vector<int>> m_corners; // of each interior vertex
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_LAGRANGIAN_H
