// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Widens triangles that an injective map has crushed. `flatten_injectively.h` calls it at the end. The paper has
// nothing like it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_WIDEN_CRUSHED_TRIANGLES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_WIDEN_CRUSHED_TRIANGLES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_differential.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>

#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

inline std::vector<Chart::Point_2> chart_points(const std::vector<Planar_point>& uv)
{
  std::vector<Chart::Point_2> result;
  for(const Planar_point& p : uv)
    result.emplace_back(p.x(), p.y());
  return result;
}

// The vertices of crushed triangles. If areas hardly count, also those of triangles that have shrunk with them.
inline std::vector<int> vertices_to_widen(const Chart& chart, const std::vector<Chart::Point_2>& uv,
                                          bool is_isometric)
{
  constexpr double most_shrinking = 100; // relative to the mean
  const Total_areas total = total_areas(chart, uv);
  const double bound = is_isometric ? (std::numeric_limits<double>::infinity)()
                                    : most_shrinking * std::sqrt(total.surface / total.plane);
  std::vector<int> result;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    if(is_crushed(chart, uv, t) ||
       (!is_needle(chart, t) && Triangle_differential(chart, uv, t).largest_stretch() > bound))
      result.insert(result.end(), &chart.vertex[3 * t], &chart.vertex[3 * t] + 3);
  return result;
}

// Crushed triangles are at a minimum of the energy by which the map was relaxed, so another energy widens them. If
// areas count, small triangles have little energy, and large ones may crush them; energies of angles do not depend on
// sizes. If areas hardly count, a vertex may shrink its whole star; the isometric energy spreads it again.
//
// `relaxation` moves the vertices of `uv`.
template <typename Relaxation>
void widen_crushed_triangles(const Chart& chart, const std::vector<Planar_point>& uv, bool is_isometric,
                             double barrier, Relaxation& relaxation)
{
  const int most_rounds = 20;
  if(!has_crushed_triangles(chart, chart_points(uv)))
    return;
  const std::vector<double> beta = is_isometric ? target_angles(chart) : std::vector<double>();
  for(int round = 0; round < most_rounds; ++round) {
    Deadline::ask();
    const std::vector<int> vertices = vertices_to_widen(chart, chart_points(uv), is_isometric);
    if(vertices.empty())
      return;
    if(is_isometric)
      relaxation.move(Angle_star(beta, Angle_energy{barrier}), vertices);
    else
      relaxation.move(Area_star(1), vertices);
  }
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_WIDEN_CRUSHED_TRIANGLES_H
