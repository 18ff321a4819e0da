// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What `Injective_descent` minimizes: an energy of `triangle_energies.h`, triangle by triangle of a whole map, and the
// sum of its derivatives for Newton's method on positions. `flatten_injectively.h` minimizes the energy of areas on
// coarse charts, where Newton's method is affordable, and polishes with that of angles, which nears the optimum of the
// direct method without any overlap.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_OBJECTIVES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_OBJECTIVES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_differential.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_energies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/triangle_assembly.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The gradient and the projected Hessian of a sum of energies of three vertices each, by the positions of all vertices.
// The three need not be a triangle: parts of the border that repel each other are coupled too. The pattern has room for
// more of these than there are at a time, so that it and its analysis serve for many steps.
class Definite_hessian
{
public:
  typedef std::array<int, 3> Triple;

  explicit Definite_hessian(const Chart& chart)
      : m_triangles(chart.number_of_triangles()), m_unknown(chart.points.size()), m_vertex(chart.vertex)
  {
    std::iota(m_unknown.begin(), m_unknown.end(), 0);
  }

  Definite_hessian(const Definite_hessian&) = delete; // the assembly refers to vertices
  Definite_hessian& operator=(const Definite_hessian&) = delete;

  // Whether the pattern has room for an energy of these vertices.
  bool couples(const Triple& vertices) const
  {
    return std::binary_search(m_triples.begin(), m_triples.end(), vertices);
  }

  bool has_pattern() const { return m_assembly.has_value(); }

  // Makes room for energies of these vertices, besides those of triangles and of earlier calls. There is no pattern
  // before the first call.
  void couple(const std::vector<Triple>& triples)
  {
    m_triples.insert(m_triples.end(), triples.begin(), triples.end());
    std::sort(m_triples.begin(), m_triples.end());
    m_triples.erase(std::unique(m_triples.begin(), m_triples.end()), m_triples.end());
    m_vertex.resize(3 * m_triangles);
    for(const Triple& triple : m_triples)
      m_vertex.insert(m_vertex.end(), triple.begin(), triple.end());
    m_derivatives.resize(m_triangles + m_triples.size());
    m_assembly.emplace(m_vertex, m_unknown, static_cast<int>(m_unknown.size()));
  }

  void clear_triples()
  {
    std::fill(m_derivatives.begin() + m_triangles, m_derivatives.end(), Triangle_derivatives());
  }

  Triangle_derivatives& of_triangle(int t) { return m_derivatives[t]; }

  // The pattern must couple the vertices.
  Triangle_derivatives& of_triple(const Triple& vertices)
  {
    const auto found = std::lower_bound(m_triples.begin(), m_triples.end(), vertices);
    return m_derivatives[m_triangles + (found - m_triples.begin())];
  }

  void sum_up()
  {
    m_gradient = Eigen::VectorXd::Zero(2 * m_unknown.size());
    for(std::size_t c = 0; c < m_vertex.size(); ++c)
      m_gradient.segment<2>(2 * m_vertex[c]) += m_derivatives[c / 3].gradient.segment<2>(2 * (c % 3));
    m_assembly->assemble([&](int c) {
      Triangle_assembly<2>::Local_columns columns;
      std::copy_n(&m_derivatives[c / 3].hessian(0, 2 * (c % 3)), 12, columns.entry);
      return columns;
    });
  }

  const Eigen::VectorXd& gradient() const { return m_gradient; }
  const Block_matrix<2>& matrix() const { return m_assembly->matrix(); }

private:
  int m_triangles;
  std::vector<int> m_unknown, m_vertex;
  std::vector<Triple> m_triples; // sorted
  std::vector<Triangle_derivatives> m_derivatives;
  std::optional<Triangle_assembly<2>> m_assembly;
  Eigen::VectorXd m_gradient;
};

// Sets `result` to a matrix with a fraction of its diagonal added.
inline void damp(const Block_matrix<2>& matrix, double fraction, Block_matrix<2>& result)
{
  result = matrix;
  for(int v = 0; v < matrix.columns_of_blocks(); ++v)
    for(int e = matrix.begin[v]; e < matrix.begin[v + 1]; ++e)
      if(matrix.row[e] == v) {
        Block_matrix<2>::Block& block = result.block[e];
        const double damping = fraction * (block(0, 0) + block(1, 1));
        block(0, 0) += damping;
        block(1, 1) += damping;
      }
}

// The energy of the direct method (Eq. 1), as a function of positions instead of angles
class Angle_objective
{
public:
  // `beta` are the target angles of all corners.
  Angle_objective(const Chart& chart, const std::vector<double>& beta, const Angle_energy& energy)
      : m_chart(chart), m_beta(beta), m_energy(energy)
  {}

  double triangle_energy(int t, const Planar_triangle& x) const
  {
    return m_chart.weight_of_triangle(t) * m_energy.value(planar_angles(x), targets(t));
  }

  Triangle_derivatives triangle_derivatives(int t, const Planar_triangle& x) const
  {
    return angle_derivatives(m_energy, m_chart.weight_of_triangle(t), targets(t), x);
  }

  double least_energy(int) const { return 0; }

  // The weight of the barrier between parts of the border. A larger one keeps them farther apart.
  double triangle_weight(int t) const { return 0.01 * m_chart.weight_of_triangle(t); }

private:
  std::array<double, 3> targets(int t) const { return {m_beta[3 * t], m_beta[3 * t + 1], m_beta[3 * t + 2]}; }

  const Chart& m_chart;
  const std::vector<double>& m_beta;
  Angle_energy m_energy;
};

// `area_energy()`
class Area_objective
{
public:
  Area_objective(const Chart& chart, double theta) : m_chart(chart), m_theta(theta)
  {
    double area = 0;
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      area += Flat_triangle(chart, t, 0).area;
    const double least_area = 1e-9 * area / chart.number_of_triangles();
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      m_triangles.emplace_back(chart, t, least_area);
  }

  double triangle_energy(int t, const Planar_triangle& x) const
  {
    return m_chart.weight_of_triangle(t) * area_energy(m_theta, m_triangles[t], x);
  }

  Triangle_derivatives triangle_derivatives(int t, const Planar_triangle& x) const
  {
    return area_derivatives(m_theta, m_chart.weight_of_triangle(t), m_triangles[t], x);
  }

  // The energy of an undistorted triangle. It also weighs the barrier between parts of the border.
  double least_energy(int t) const { return triangle_weight(t); }
  double triangle_weight(int t) const { return m_chart.weight_of_triangle(t) * m_triangles[t].area; }

private:
  const Chart& m_chart;
  double m_theta;
  std::vector<Flat_triangle> m_triangles;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_OBJECTIVES_H
