// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The scale of a conformal map, predicted from angle defects by one Poisson equation (Ben-Chen, Gotsman and Bunin
// 2008). `find_seams_impl.h` chooses and judges seams by it, and
// `cones/cone_charges.h` chooses cones.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_LOG_SCALE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_LOG_SCALE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/exact_layout.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/newton_equation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/triangle_assembly.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Predicts by how much a conformal map of the opened surface changes lengths: log scale factors u with L u = -K, where
// L is the cotangent Laplacian and K the angle defect, and u = 0 on seams and borders.
class Log_scale
{
public:
  Log_scale(const Chart& surface, const Linear_solvers& solvers)
      : m_surface(surface), m_solvers(solvers), m_cotangents(cotangents(proper_angles(surface))),
        m_defect(surface.points.size(), 2 * pi), m_area(surface.points.size(), 0.)
  {
    for(int c = 0; c < surface.number_of_corners(); ++c)
      m_defect[surface.vertex[c]] -= surface_angle(surface, c);
    for(int t = 0; t < surface.number_of_triangles(); ++t)
      for(int c = 3 * t; c < 3 * t + 3; ++c)
        m_area[surface.vertex[c]] += surface_area(surface, t) / 3;
    for(double a : m_area)
      m_total_area += a;
  }

  // The right-hand sides, for Laplacians with twice the usual weights. On a closed surface of which one vertex is
  // fixed, they may be made to sum to 0: the solution then depends on this vertex only up to a constant.
  Eigen::VectorXd sources(bool are_balanced = false) const
  {
    const double mean = are_balanced && m_total_area > 0 ? 4 * pi / m_total_area : 0;
    Eigen::VectorXd result(m_surface.number_of_vertices());
    for(int v = 0; v < m_surface.number_of_vertices(); ++v)
      result[v] = -2 * (m_defect[v] - mean * m_area[v]);
    return result;
  }

  // The log scale of each vertex; nothing if the linear solver fails
  std::optional<Eigen::VectorXd> solve(const std::vector<char>& is_fixed) const
  {
    int unknowns = 0;
    const std::vector<int> unknown = number_unknowns(is_fixed, unknowns);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(m_surface.number_of_vertices());
    if(unknowns == 0)
      return u;
    const Eigen::VectorXd all = sources();
    Two_vectors some = {Eigen::VectorXd::Zero(unknowns), Eigen::VectorXd::Zero(unknowns)}, solutions;
    for(int v = 0; v < m_surface.number_of_vertices(); ++v)
      if(unknown[v] >= 0)
        some[0][unknown[v]] = all[v];
    if(!solve_definite(laplacian(unknown, unknowns).matrix(), *m_solvers->low_precision(), some, solutions))
      return std::nullopt;
    for(int v = 0; v < m_surface.number_of_vertices(); ++v)
      if(unknown[v] >= 0)
        u[v] = solutions[0][unknown[v]];
    return u;
  }

  // The L2 stretch of a map with these log scale factors, after the best scaling
  double stretch(const Eigen::VectorXd& u) const
  {
    if(!(m_total_area > 0))
      return 1;
    double shrunk = 0, grown = 0;
    for(std::size_t v = 0; v < m_area.size(); ++v) {
      const double x = u[static_cast<Eigen::Index>(v)];
      shrunk += m_area[v] * std::exp(-2 * x);
      grown += m_area[v] * std::exp(2 * x);
    }
    return std::sqrt(shrunk / m_total_area * (grown / m_total_area));
  }

  // Numbers the vertices that are not fixed; the others get -1.
  static std::vector<int> number_unknowns(const std::vector<char>& is_fixed, int& count)
  {
    std::vector<int> unknown(is_fixed.size(), -1);
    count = 0;
    for(std::size_t v = 0; v < is_fixed.size(); ++v)
      if(!is_fixed[v])
        unknown[v] = count++;
    return unknown;
  }

  // The Laplacian of some vertices, with twice the usual weights
  Triangle_assembly<1> laplacian(const std::vector<int>& unknown, int n) const
  {
    return cotangent_laplacian(m_surface, m_cotangents, unknown, n);
  }

  // The Laplacian of all vertices, with twice the usual weights
  Block_matrix<1> laplacian() const
  {
    std::vector<int> all(m_surface.points.size());
    std::iota(all.begin(), all.end(), 0);
    return laplacian(all, m_surface.number_of_vertices()).matrix();
  }

  const std::vector<double>& defects() const { return m_defect; } // of each vertex, as if it were inside
  const std::vector<double>& areas() const { return m_area; }     // of each vertex
  double total_area() const { return m_total_area; }

private:
  // Angles that sum to pi in each triangle, so that its part of the Laplacian is positive semidefinite. Angles near 0
  // are raised to the least target angle, and the largest one is the rest of pi.
  static std::vector<double> proper_angles(const Chart& surface)
  {
    std::vector<double> angles(surface.vertex.size());
    for(int t = 0; t < surface.number_of_triangles(); ++t) {
      double* const begin = angles.data() + 3 * t;
      for(int k = 0; k < 3; ++k)
        begin[k] = (std::max)(surface_angle(surface, 3 * t + k), least_target_angle);
      double* const largest = std::max_element(begin, begin + 3);
      *largest = 0;
      *largest = pi - begin[0] - begin[1] - begin[2];
    }
    return angles;
  }

  const Chart& m_surface;
  const Linear_solvers& m_solvers;
  const std::vector<double> m_cotangents;
  std::vector<double> m_defect, m_area; // of each vertex
  double m_total_area = 0;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_LOG_SCALE_H
