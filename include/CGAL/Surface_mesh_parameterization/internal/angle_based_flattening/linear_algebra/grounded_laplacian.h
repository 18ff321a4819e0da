// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Laplace equations with zeros at vertices that change from one solution to the next, by one factorization: a small
// dense matrix makes up for the changes. `seams/find_seams_impl.h` predicts scales with it while seams grow.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_GROUNDED_LAPLACIAN_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_GROUNDED_LAPLACIAN_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

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
// column of G_vv, and the Cholesky factor of G_vv grows by a column. Where that would take longer than a factorization,
// or a vertex of the factored matrix is no longer grounded, the matrix is factored again. Its pattern is always that of
// L, and is analyzed once. All memory is kept.
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
      : m_laplacian(std::move(laplacian)), m_matrix(m_laplacian), m_solver(solvers->full_precision()),
        m_keeps_factors(solvers->keeps_factors())
  {}

  // Some vertices must be grounded. Returns `false` if the linear solver fails.
  bool solve(const std::vector<char>& is_grounded, const Eigen::VectorXd& sources, Eigen::VectorXd& u)
  {
    if(m_is_factored && m_keeps_factors && ground(is_grounded) && solve_with_columns(sources, u))
      return true;
    return factor(is_grounded) && respond(right_hand_side(sources), u);
  }

private:
  bool factor(const std::vector<char>& is_grounded)
  {
    forget_columns();
    m_reference = -1;
    m_is_in_factor = is_grounded;
    m_matrix.block = m_laplacian.block;
    for(int j = 0; j < m_matrix.columns_of_blocks(); ++j)
      for(int e = m_matrix.begin[j]; e < m_matrix.begin[j + 1]; ++e)
        if(is_grounded[j] || is_grounded[m_matrix.row[e]])
          m_matrix.block[e](0, 0) = m_matrix.row[e] == j;
    return m_is_factored = m_solver->set_matrix(m_matrix);
  }

  Eigen::VectorXd& right_hand_side(const Eigen::VectorXd& sources)
  {
    set_size(m_right_hand_side, sources.size());
    return m_right_hand_side = sources;
  }

  // u = G q, where q is overwritten. With a reference, the factored matrix has one grounded vertex, which is not
  // grounded now: u is shifted so that it vanishes at the reference instead.
  bool respond(Eigen::VectorXd& sources, Eigen::VectorXd& u)
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
    m_is_known = m_is_in_factor;
    if(m_reference >= 0) {
      std::fill(m_is_known.begin(), m_is_known.end(), false);
      m_is_known[m_reference] = true;
    }
    for(int v : m_further)
      m_is_known[v] = true;
    m_added.clear();
    for(std::size_t v = 0; v < is_grounded.size(); ++v)
      if(is_grounded[v] && !m_is_known[v])
        m_added.push_back(static_cast<int>(v));
    return m_added.size() <= most_columns && m_further.size() + m_added.size() <= most_further_vertices &&
           std::all_of(m_added.begin(), m_added.end(), [&](int v) { return add_column(v); });
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
    m_knows_response_to_sources = false;
  }

  // Without further vertices that are no longer grounded
  void release(const std::vector<char>& is_grounded)
  {
    std::vector<int> kept;
    for(std::size_t i = 0; i < m_further.size(); ++i)
      if(is_grounded[m_further[i]])
        kept.push_back(static_cast<int>(i));
    if(kept.size() == m_further.size())
      return;
    const auto n = static_cast<Eigen::Index>(kept.size());
    for(Eigen::Index j = 0; j < n; ++j) {
      m_further[j] = m_further[kept[j]];
      for(Eigen::Index i = 0; i <= j; ++i)
        m_response(i, j) = m_response(kept[i], kept[j]);
    }
    m_further.resize(n);
    Eigen::Ref<Eigen::MatrixXd> factor = m_factor.topLeftCorner(n, n);
    factor = m_response.topLeftCorner(n, n);
    if(Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>, Eigen::Upper>(factor).info() != Eigen::Success)
      forget_columns();
  }

  // Makes room for rows and columns of further vertices.
  void reserve(Eigen::Index n)
  {
    if(n <= m_response.rows())
      return;
    const Eigen::Index room = (std::min)(2 * n, static_cast<Eigen::Index>(most_further_vertices));
    m_response.conservativeResize(room, room);
    m_factor.conservativeResize(room, room);
  }

  // Makes a vertex a further one. Returns `false` if that cannot be done.
  bool add_column(int v)
  {
    const auto n = static_cast<Eigen::Index>(m_further.size());
    set_size(m_right_hand_side, m_laplacian.columns_of_blocks());
    m_right_hand_side.setZero();
    m_right_hand_side[v] = 1;
    if(!respond(m_right_hand_side, m_column))
      return false;
    m_further.push_back(v);
    reserve(n + 1);
    for(Eigen::Index i = 0; i <= n; ++i)
      m_response(i, n) = m_column[m_further[i]];
    auto column = m_factor.col(n).head(n);
    column = m_response.col(n).head(n);
    m_factor.topLeftCorner(n, n).triangularView<Eigen::Upper>().transpose().solveInPlace(column);
    const double square = m_response(n, n) - column.squaredNorm();
    m_factor(n, n) = std::sqrt(square);
    return square > 0;
  }

  // Returns `false` also if u does not vanish where it should.
  bool solve_with_columns(const Eigen::VectorXd& sources, Eigen::VectorXd& u)
  {
    if(!m_knows_response_to_sources || sources != m_sources) {
      set_size(m_sources, sources.size());
      m_sources = sources;
      if(!respond(right_hand_side(sources), m_response_to_sources))
        return false;
      m_knows_response_to_sources = true;
    }
    const auto further = static_cast<Eigen::Index>(m_further.size());
    Eigen::VectorXd values(further);
    for(Eigen::Index i = 0; i < further; ++i)
      values[i] = m_response_to_sources[m_further[i]];
    const auto factor = m_factor.topLeftCorner(further, further);
    factor.triangularView<Eigen::Upper>().transpose().solveInPlace(values);
    factor.triangularView<Eigen::Upper>().solveInPlace(values);
    Eigen::VectorXd& balanced = right_hand_side(sources);
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
  Block_matrix<1> m_matrix; // the factored one
  const std::unique_ptr<Linear_solver> m_solver;
  const bool m_keeps_factors;
  bool m_is_factored = false;
  std::vector<char> m_is_in_factor; // of each vertex: whether it was grounded when the matrix was factored
  int m_reference = -1;             // the vertex where u vanishes instead of there, or -1
  std::vector<int> m_further;       // the other grounded vertices
  Eigen::MatrixXd m_response;       // G_vv of these: its upper triangle, with room for more
  Eigen::MatrixXd m_factor;         // its Cholesky factor U, where U^T U = G_vv, alike
  Eigen::VectorXd m_sources, m_response_to_sources; // the last ones, and G q of these
  bool m_knows_response_to_sources = false;

  // Memory that is kept
  std::vector<char> m_is_known;
  std::vector<int> m_added;
  Eigen::VectorXd m_right_hand_side, m_column;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LINEAR_ALGEBRA_GROUNDED_LAPLACIAN_H
