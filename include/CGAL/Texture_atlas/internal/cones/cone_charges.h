// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Chooses cones greedily, and computes their charges from the log scale of a conformal map that curvature at some
// vertices causes, with one factorization for all. `choose_cones_impl.h` makes angles of the charges.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CONE_CHARGES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CONE_CHARGES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/log_scale.h>
#include <CGAL/Texture_atlas/internal/seams/piece.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// How the log scale of a conformal map responds to curvature at vertices: L u = q, with u = 0 at the border, for any
// number of q by one factorization. On a closed surface, u = 0 at one vertex, whose q makes the sum of all q vanish.
class Scale_response
{
public:
  Scale_response(const Chart& surface, const Log_scale& log_scale, const Linear_solvers& solvers)
      : m_solver(solvers->full_precision())
  {
    std::vector<char> is_fixed;
    for(int rank : surface.interior)
      is_fixed.push_back(rank < 0);
    if(surface.borders.empty())
      is_fixed.front() = true;
    m_unknown = Log_scale::number_unknowns(is_fixed, m_unknowns);
    m_is_factored =
        m_unknowns == 0 || m_solver->set_matrix(log_scale.laplacian(m_unknown, m_unknowns).matrix());
  }

  // The response of all vertices to sources at all vertices; nothing if the linear solver fails
  std::optional<Eigen::VectorXd> operator()(const Eigen::VectorXd& sources)
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(sources.size());
    if(m_unknowns == 0)
      return result;
    Eigen::VectorXd right_hand_side(m_unknowns), solution;
    for(std::size_t v = 0; v < m_unknown.size(); ++v)
      if(m_unknown[v] >= 0)
        right_hand_side[m_unknown[v]] = 2 * sources[v]; // the matrix has twice the usual weights
    if(!m_is_factored || !m_solver->solve(right_hand_side, solution))
      return std::nullopt;
    for(std::size_t v = 0; v < m_unknown.size(); ++v)
      if(m_unknown[v] >= 0)
        result[v] = solution[m_unknown[v]];
    return result;
  }

private:
  std::unique_ptr<Linear_solver> m_solver;
  std::vector<int> m_unknown; // of each vertex
  int m_unknowns = 0;
  bool m_is_factored = false;
};

// The Cholesky factor of a small dense matrix that gets one row and column after the other
class Growing_cholesky
{
public:
  // Appends the last column of a larger matrix. Returns `false` if that is not positive definite.
  bool append(const Eigen::VectorXd& column)
  {
    const Eigen::Index n = m_factor.rows();
    const Eigen::VectorXd row =
        m_factor.triangularView<Eigen::Lower>().solve(Eigen::VectorXd(column.head(n)));
    const double square = column[n] - row.squaredNorm();
    if(!(square > 0))
      return false;
    m_factor.conservativeResize(n + 1, n + 1);
    m_factor.row(n).head(n) = row.transpose();
    m_factor(n, n) = std::sqrt(square);
    return true;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right_hand_side) const
  {
    Eigen::VectorXd solution = m_factor.triangularView<Eigen::Lower>().solve(right_hand_side);
    m_factor.triangularView<Eigen::Lower>().transpose().solveInPlace(solution);
    return solution;
  }

private:
  Eigen::MatrixXd m_factor; // its lower triangle
};

// If the log scale varies less than this, no vertex is better than another one.
inline constexpr double least_log_scale = 1e-9;

// Chooses cones, each where the scale with the earlier cones is farthest from 1, and their charges. The charge of a
// cone is a full turn minus its angle.
class Cone_charges
{
public:
  Cone_charges(const Chart& surface, const Linear_solvers& solvers)
      : m_surface(surface), m_log_scale(surface, solvers), m_response(surface, m_log_scale, solvers),
        m_total(2 * pi * euler_characteristic(surface)),
        m_curvature(Eigen::Map<const Eigen::VectorXd>(m_log_scale.defects().data(), size())),
        m_area(Eigen::Map<const Eigen::VectorXd>(m_log_scale.areas().data(), size()))
  {}

  const std::vector<int>& cones() const { return m_cones; }
  const Eigen::VectorXd& charges() const { return m_charges; }

  // The charge of all cones together, if the surface is closed
  double total() const { return m_total; }

  // Returns `false` if the linear solver fails, as the other functions do.
  bool choose(std::size_t number_of_cones)
  {
    std::optional<Eigen::VectorXd> u = m_response(-m_curvature);
    if(!u)
      return false;
    m_base = *u;
    if(is_closed())
      u = scale_without_cones();
    while(u && m_cones.size() < number_of_cones) {
      Deadline::ask();
      int cone = -1;
      for(int v = 0; v < size(); ++v)
        if((cone < 0 || std::abs((*u)[v]) > std::abs((*u)[cone])) && is_free(v))
          cone = v;
      if(cone < 0)
        return true;
      if(std::abs((*u)[cone]) <= least_log_scale) {
        if(!(is_closed() && m_cones.empty() && m_total != 0))
          return true;
        cone = 0; // on a regular polyhedron all vertices are alike, and there must be some cone
      }
      if(!add(cone))
        return false;
      u = scale();
    }
    return u.has_value();
  }

  // Replaces the charges that make u vanish at the cones by those with which u varies least.
  bool balance()
  {
    const int bound = number_of_bound_cones(), n = number_of_cones() - bound;
    if(n == 0 || !(m_log_scale.total_area() > 0))
      return true;
    // The mean square of u = base + sum of charges * green functions is least where its gradient vanishes. The products
    // of these functions come from a second response to each.
    Eigen::MatrixXd products(n, n);
    for(int i = 0; i < n; ++i) {
      const std::optional<Eigen::VectorXd> green = green_function(m_cones[i + bound]),
                                           second = green ? m_response(weighted(*green)) : std::nullopt;
      if(!second)
        return false;
      products.col(i) = at_cones(*second);
    }
    const std::optional<Eigen::VectorXd> second = m_response(weighted(m_base));
    if(!second)
      return false;
    set_charges(products.partialPivLu().solve(-at_cones(*second)));
    return m_charges.allFinite();
  }

  // The stretch that these charges predict; nothing if the linear solver fails
  std::optional<double> stretch(const std::vector<int>& cones, const std::vector<double>& charges)
  {
    m_cones = cones;
    m_charges = Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(charges.data(), number_of_cones()));
    const std::optional<Eigen::VectorXd> u = scale();
    return u ? std::optional<double>(m_log_scale.stretch(*u)) : std::nullopt;
  }

private:
  int size() const { return m_surface.number_of_vertices(); }
  int number_of_cones() const { return static_cast<int>(m_cones.size()); }
  bool is_closed() const { return m_surface.borders.empty(); }

  // The scale with these cones and charges, up to a constant on a closed surface
  std::optional<Eigen::VectorXd> scale()
  {
    Eigen::VectorXd sources = -m_curvature;
    for(int i = 0; i < number_of_cones(); ++i)
      sources[m_cones[i]] += m_charges[i];
    std::optional<Eigen::VectorXd> u = m_response(sources);
    if(u && is_closed() && !m_cones.empty())
      u->array() -= (*u)[m_cones.front()];
    return u;
  }

  bool is_free(int v) const
  {
    return m_surface.interior[v] >= 0 && std::find(m_cones.begin(), m_cones.end(), v) == m_cones.end();
  }

  // The scale of the map from a closed surface to one of constant curvature, relative to its mean
  std::optional<Eigen::VectorXd> scale_without_cones()
  {
    if(!(m_log_scale.total_area() > 0))
      return m_base;
    std::optional<Eigen::VectorXd> u =
        m_response(m_curvature.sum() / m_log_scale.total_area() * m_area - m_curvature);
    if(u)
      u->array() -= m_area.dot(*u) / m_log_scale.total_area();
    return u;
  }

  // Adds a cone, and finds the charges that make u vanish at all cones. The first one of a closed surface takes the
  // rest of the total.
  bool add(int cone)
  {
    const std::optional<Eigen::VectorXd> green = green_function(cone);
    if(!green)
      return false;
    m_cones.push_back(cone);
    if(is_closed() && number_of_cones() == 1) {
      m_base += m_total * *green;
      m_charges = Eigen::VectorXd(Eigen::VectorXd::Constant(1, m_total));
      return true;
    }
    if(!m_green.append(at_cones(*green)))
      return false;
    set_charges(m_green.solve(-at_cones(m_base)));
    return m_charges.allFinite();
  }

  // The response to a unit at a cone, and to its opposite at the first one of a closed surface
  std::optional<Eigen::VectorXd> green_function(int cone)
  {
    Eigen::VectorXd unit = Eigen::VectorXd::Unit(size(), cone);
    if(number_of_bound_cones() == 1)
      unit[m_cones.front()] -= 1;
    return m_response(unit);
  }

  int number_of_bound_cones() const { return is_closed() && !m_cones.empty() ? 1 : 0; }

  // The values at the cones with charges of their own; on a closed surface the differences from the first cone
  Eigen::VectorXd at_cones(const Eigen::VectorXd& u) const
  {
    const int bound = number_of_bound_cones();
    Eigen::VectorXd values(number_of_cones() - bound);
    for(int i = bound; i < number_of_cones(); ++i)
      values[i - bound] = u[m_cones[i]] - (bound == 1 ? u[m_cones.front()] : 0);
    return values;
  }

  void set_charges(const Eigen::VectorXd& own)
  {
    set_size(m_charges, number_of_cones());
    if(number_of_bound_cones() == 1)
      m_charges << m_total - own.sum(), own;
    else
      m_charges = own;
  }

  // Times the areas, without the mean
  Eigen::VectorXd weighted(const Eigen::VectorXd& u) const
  {
    return m_area.cwiseProduct(u) - m_area * (m_area.dot(u) / m_log_scale.total_area());
  }

  const Chart& m_surface;
  const Log_scale m_log_scale;
  Scale_response m_response;
  const double m_total;
  const Eigen::VectorXd m_curvature, m_area;
  Eigen::VectorXd
      m_base; // the response to the curvature, and to the whole charge of a closed surface at its first cone
  Growing_cholesky m_green; // of the Green functions at the cones
  std::vector<int> m_cones;
  Eigen::VectorXd m_charges;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_CONES_CONE_CHARGES_H
