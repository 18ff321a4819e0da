// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Laplace equations with zeros at vertices that change from one solution to the next, by one factorization: a small
// dense matrix makes up for the changes. `seams/greedy_cones.h` predicts scales with it while seams grow.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_GROUNDED_LAPLACIAN_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_GROUNDED_LAPLACIAN_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/symmetric_system.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Solves L u = q with u = 0 at grounded vertices, where L is the Laplacian of a connected surface: its rows sum to 0.
//
// The first grounded vertices are in the factored matrix. If G is its inverse, then sources s at further ones, with
// G_vv s = -(G q)_v, make u = G (q + s) vanish at all of them (v). Each further vertex takes one solution, for its
// column of G_vv, and the Cholesky factor of G_vv grows by a row. Where that would take longer than a factorization, or
// a vertex of the factored matrix is no longer grounded, the matrix is factored again. Its pattern is always that of L,
// and is analyzed once.
class Grounded_laplacian
{
public:
  // So many solutions take as long as a factorization, at 5000 vertices.
  static constexpr std::size_t most_columns = 40;

  // A larger matrix G_vv takes longer than a factorization now and then.
  static constexpr std::size_t most_further_vertices = 600;

  // of u where it should vanish, in parts of its largest value; otherwise the matrix is factored again
  static constexpr double largest_error = 1e-11;

  Grounded_laplacian(Block_matrix<1> laplacian, const Linear_solvers& solvers)
      : m_laplacian(std::move(laplacian)), m_solver(solvers->full_precision()),
        m_keeps_factors(solvers->keeps_factors)
  {}

  // Some vertices must be grounded. Returns `false` if the linear solver fails.
  bool solve(const std::vector<char>& is_grounded, const Eigen::VectorXd& sources, Eigen::VectorXd& u)
  {
    if(m_is_factored && m_keeps_factors && ground(is_grounded) && solve_with_columns(sources, u))
      return true;
    return factor(is_grounded) && respond(sources, u);
  }

private:
  bool factor(const std::vector<char>& is_grounded)
  {
    forget_columns();
    m_reference = -1;
    m_is_in_factor = is_grounded;
    Block_matrix<1> matrix = m_laplacian;
    for(int j = 0; j < matrix.columns_of_blocks(); ++j)
      for(int e = matrix.begin[j]; e < matrix.begin[j + 1]; ++e)
        if(is_grounded[j] || is_grounded[matrix.row[e]])
          matrix.block[e](0, 0) = matrix.row[e] == j;
    return m_is_factored = m_solver->set_matrix(matrix);
  }

  // u = G q. With a reference, the factored matrix has one grounded vertex, which is not grounded now: u is shifted so
  // that it vanishes at the reference instead.
  bool respond(Eigen::VectorXd sources, Eigen::VectorXd& u)
  {
    if(m_reference >= 0)
      sources[m_reference] -= sources.sum();
    for(Eigen::Index v = 0; v < sources.size(); ++v)
      if(m_is_in_factor[v])
        sources[v] = 0;
    if(!m_solver->solve(sources, u))
      return false;
    if(const double shift = m_reference >= 0 ? u[m_reference] : 0; shift != 0)
      u.array() -= shift;
    return true;
  }

  // Makes `m_further` the grounded vertices that are neither in the factored matrix nor the reference. Returns `false`
  // if that cannot be done, or would take longer than a factorization.
  bool ground(const std::vector<char>& is_grounded)
  {
    if(!has_reference(is_grounded))
      return false;
    release(is_grounded);
    std::vector<char> is_known =
        m_reference < 0 ? m_is_in_factor : std::vector<char>(is_grounded.size(), false);
    if(m_reference >= 0)
      is_known[m_reference] = true;
    for(int v : m_further)
      is_known[v] = true;
    std::vector<int> added;
    for(std::size_t v = 0; v < is_grounded.size(); ++v)
      if(is_grounded[v] && !is_known[v])
        added.push_back(static_cast<int>(v));
    return added.size() <= most_columns && m_further.size() + added.size() <= most_further_vertices &&
           (added.empty() || add_columns(added));
  }

  // Chooses another reference if the present one, or what is in the factored matrix, is no longer grounded.
  bool has_reference(const std::vector<char>& is_grounded)
  {
    if(m_reference >= 0 && is_grounded[m_reference])
      return true;
    std::size_t number = 0, released = 0;
    for(std::size_t v = 0; v < is_grounded.size(); ++v) {
      number += m_is_in_factor[v] != 0;
      released += m_is_in_factor[v] && !is_grounded[v];
    }
    if(m_reference < 0 && released == 0)
      return true;
    const auto first = std::find(is_grounded.begin(), is_grounded.end(), true);
    if(number != 1 || first == is_grounded.end())
      return false;
    forget_columns();
    m_reference = static_cast<int>(first - is_grounded.begin());
    return true;
  }

  void forget_columns()
  {
    m_further.clear();
    m_response.resize(0, 0);
    m_factor.resize(0, 0);
    m_response_to_sources.resize(0);
  }

  // Without further vertices that are no longer grounded
  void release(const std::vector<char>& is_grounded)
  {
    std::vector<int> kept, vertices;
    for(std::size_t i = 0; i < m_further.size(); ++i)
      if(is_grounded[m_further[i]]) {
        kept.push_back(static_cast<int>(i));
        vertices.push_back(m_further[i]);
      }
    if(kept.size() == m_further.size())
      return;
    m_further = std::move(vertices);
    m_response = Eigen::MatrixXd(m_response(kept, kept));
    m_factor = Eigen::MatrixXd(m_response.llt().matrixL());
  }

  bool add_columns(const std::vector<int>& added)
  {
    const auto old = static_cast<Eigen::Index>(m_further.size());
    const auto more = static_cast<Eigen::Index>(added.size()), all = old + more;
    m_further.insert(m_further.end(), added.begin(), added.end());
    m_response.conservativeResize(all, all);
    Eigen::VectorXd column;
    for(Eigen::Index j = old; j < all; ++j) {
      Eigen::VectorXd unit = Eigen::VectorXd::Zero(m_laplacian.columns_of_blocks());
      unit[m_further[j]] = 1;
      if(!respond(unit, column))
        return false;
      for(Eigen::Index i = 0; i < all; ++i)
        m_response(i, j) = column[m_further[i]];
      m_response.row(j).head(old) = m_response.col(j).head(old).transpose();
    }
    const auto triangle = m_factor.triangularView<Eigen::Lower>();
    const Eigen::MatrixXd beside = triangle.solve(m_response.topRightCorner(old, more)).transpose();
    const Eigen::LLT<Eigen::MatrixXd> below(m_response.bottomRightCorner(more, more) -
                                            beside * beside.transpose());
    if(below.info() != Eigen::Success)
      return false;
    m_factor.conservativeResize(all, all);
    m_factor.bottomLeftCorner(more, old) = beside;
    m_factor.topRightCorner(old, more).setZero();
    m_factor.bottomRightCorner(more, more) = below.matrixL();
    return true;
  }

  // Returns `false` also if u does not vanish where it should.
  bool solve_with_columns(const Eigen::VectorXd& sources, Eigen::VectorXd& u)
  {
    if(m_response_to_sources.size() == 0 || sources != m_sources) {
      m_sources = sources;
      if(!respond(sources, m_response_to_sources))
        return false;
    }
    const auto further = static_cast<Eigen::Index>(m_further.size());
    Eigen::VectorXd balanced = sources, values(further);
    for(Eigen::Index i = 0; i < further; ++i)
      values[i] = m_response_to_sources[m_further[i]];
    m_factor.triangularView<Eigen::Lower>().solveInPlace(values);
    m_factor.transpose().triangularView<Eigen::Upper>().solveInPlace(values);
    for(Eigen::Index i = 0; i < further; ++i)
      balanced[m_further[i]] -= values[i];
    if(!respond(balanced, u))
      return false;
    double error = 0;
    const double largest = u.cwiseAbs().maxCoeff();
    for(int v : m_further) {
      error = (std::max)(error, std::abs(u[v]));
      u[v] = 0;
    }
    return error <= largest_error * largest;
  }

  const Block_matrix<1> m_laplacian;
  const std::unique_ptr<Linear_solver> m_solver;
  const bool m_keeps_factors;
  bool m_is_factored = false;
  std::vector<char> m_is_in_factor; // of each vertex: whether it was grounded when the matrix was factored
  int m_reference = -1;             // the vertex where u vanishes instead of there, or -1
  std::vector<int> m_further;       // the other grounded vertices
  Eigen::MatrixXd m_response;       // G_vv of these
  Eigen::MatrixXd m_factor;         // its lower Cholesky factor
  Eigen::VectorXd m_sources, m_response_to_sources; // the last ones, and G q of these
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_GROUNDED_LAPLACIAN_H
