// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves for the log scale of a conformal map that curvature at some vertices causes, many times with one
// factorization. `cone_charges.h` asks it for each cone.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_CONES_SCALE_RESPONSE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_CONES_SCALE_RESPONSE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/internal/seams/log_scale.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
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

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_CONES_SCALE_RESPONSE_H
