// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The first injective map of a coarse chart, from which `flatten_injectively.h` descends: one that is given, or that of
// Tutte (1963) with the border on a circle and all weights equal, which is injective on any disk without parallel
// edges.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_TUTTE_MAP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_TUTTE_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/block_matrix.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Tutte's map of a disk to a circle, of the area of the surface: each interior vertex is the mean of its neighbours. It
// is injective but for rounding, on any disk without parallel edges.
class Tutte_map
{
public:
  explicit Tutte_map(const Chart& chart) : m_chart(chart), m_uv(chart.points.size(), Planar_point(0, 0))
  {
    place_border();
  }

  // Returns nothing if the linear solver fails.
  std::optional<std::vector<Planar_point>> run(const Linear_solvers& solvers)
  {
    const int n = m_chart.number_of_interior_vertices;
    if(n > 0) {
      const std::vector<std::map<int, int>> rows = neighbours();
      const std::unique_ptr<Linear_solver> solver = solvers->full_precision();
      if(!solver->set_matrix(laplacian(rows)))
        return std::nullopt;
      for(int k = 0; k < 2; ++k) {
        Eigen::VectorXd solution;
        if(!solver->solve(right_hand_side(rows, k), solution))
          return std::nullopt;
        for(std::size_t v = 0; v < m_uv.size(); ++v)
          if(m_chart.interior[v] >= 0)
            m_uv[v][k] = solution[m_chart.interior[v]];
      }
    }
    return m_uv;
  }

private:
  // Border edges get arcs that grow with their lengths, but none vanishes.
  void place_border()
  {
    const std::vector<int>& border = m_chart.borders.front();
    double length = 0, area = 0, position = 0;
    for(int c : border)
      length += edge_length(m_chart, c);
    const double least_arc = length > 0 ? 0.1 * length / static_cast<double>(border.size()) : 1;
    const double whole = length + least_arc * static_cast<double>(border.size());
    for(int t = 0; t < m_chart.number_of_triangles(); ++t)
      area += surface_area(m_chart, t);
    const double radius = area > 0 ? std::sqrt(area / pi) : 1;
    for(int c : border) {
      const double angle = 2 * pi * position / whole;
      m_uv[m_chart.edge_source(c)] = radius * Planar_point(std::cos(angle), std::sin(angle));
      position += edge_length(m_chart, c) + least_arc;
    }
  }

  // Of each interior vertex: how often another one is its neighbour, counting each edge twice
  std::vector<std::map<int, int>> neighbours() const
  {
    std::vector<std::map<int, int>> rows(m_chart.number_of_interior_vertices);
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      if(const int row = m_chart.interior[m_chart.vertex[c]]; row >= 0) {
        ++rows[row][m_chart.vertex[next_corner(c)]];
        ++rows[row][m_chart.vertex[previous_corner(c)]];
      }
    return rows;
  }

  Block_matrix<1> laplacian(const std::vector<std::map<int, int>>& rows) const
  {
    Block_matrix<1> matrix;
    for(std::size_t i = 0; i < rows.size(); ++i) {
      std::map<int, double> column;
      for(const auto& [v, number] : rows[i]) {
        column[static_cast<int>(i)] += number;
        if(m_chart.interior[v] >= 0)
          column[m_chart.interior[v]] -= number;
      }
      for(const auto& [row, value] : column) {
        matrix.row.push_back(row);
        matrix.block.push_back({{value}});
      }
      matrix.begin.push_back(static_cast<int>(matrix.row.size()));
    }
    return matrix;
  }

  Eigen::VectorXd right_hand_side(const std::vector<std::map<int, int>>& rows, int k) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<int>(rows.size()));
    for(std::size_t i = 0; i < rows.size(); ++i)
      for(const auto& [v, number] : rows[i])
        if(m_chart.interior[v] < 0)
          result[i] += number * m_uv[v][k];
    return result;
  }

  const Chart& m_chart;
  std::vector<Planar_point> m_uv;
};

// A given map of a whole chart at the vertices of a coarse one, as large as the surface of that; nothing if it has no
// area
inline std::optional<std::vector<Planar_point>> map_of_coarse_chart(const std::vector<Chart::Point_2>& map,
                                                                    const Coarse_chart& coarse)
{
  std::vector<Planar_point> uv;
  for(int v : coarse.vertices)
    uv.emplace_back(map[v].x(), map[v].y());
  double surface = 0, plane = 0;
  for(int t = 0; t < coarse.chart.number_of_triangles(); ++t) {
    const int* v = &coarse.chart.vertex[3 * t];
    surface += surface_area(coarse.chart, t);
    plane += cross(uv[v[1]] - uv[v[0]], uv[v[2]] - uv[v[0]]) / 2;
  }
  if(!(plane > 0))
    return std::nullopt;
  for(Planar_point& p : uv)
    p *= std::sqrt(surface / plane);
  return uv;
}

inline bool is_injective_map(const Chart& chart, const std::vector<Planar_point>& uv)
{
  std::vector<Exact_point_2> points;
  for(const Planar_point& p : uv)
    points.emplace_back(p.x(), p.y());
  return flipped_triangles(chart.vertex, points).empty() && is_border_simple(chart, points);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_TUTTE_MAP_H
