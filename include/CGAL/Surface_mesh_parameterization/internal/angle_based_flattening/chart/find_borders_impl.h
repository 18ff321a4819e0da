// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Follows the borders of a chart, and numbers its constraint nodes.
// These are the bodies of `find_borders.h`, which the compiled library has.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FIND_BORDERS_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FIND_BORDERS_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/seam_nodes.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<int> vertices_with_prescribed_angles(const Chart& chart)
{
  std::vector<int> vertices;
  if(chart.has_prescribed_border())
    for(int c : chart.borders.front())
      if(chart.is_angle_prescribed(chart.edge_source(c)))
        vertices.push_back(chart.edge_source(c));
  return vertices;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE bool is_whole_border_prescribed(const Chart& chart)
{
  return chart.has_prescribed_border() &&
         vertices_with_prescribed_angles(chart).size() == chart.borders.front().size();
}

CGAL_ANGLE_BASED_FLATTENING_INLINE void find_nodes(Chart& chart)
{
  chart.node = chart.interior;
  chart.nodes.assign(chart.number_of_interior_vertices, Constraint_node());
  const auto add_node = [&](int v, const Constraint_node& node) {
    chart.node[v] = chart.number_of_nodes();
    chart.nodes.push_back(node);
  };
  if(chart.equal_seams)
    Seam_nodes(chart).add();
  for(int v : vertices_with_prescribed_angles(chart))
    add_node(v, {chart.angle_sums[v], true, false});
  if(is_whole_border_prescribed(chart))
    chart.nodes.back().has_planarity = false; // it follows from all others
  chart.number_of_bound_nodes = -chart.number_of_nodes();
  for(int k = 0; k < chart.number_of_holes(); ++k)
    for(int c : chart.hole(k))
      add_node(chart.edge_source(c), Constraint_node());
  chart.number_of_bound_nodes += chart.number_of_nodes();
}

CGAL_ANGLE_BASED_FLATTENING_INLINE void equalize_outer_seams(Chart& chart)
{
  chart.equal_seams = Seam_places(chart).has_seams();
  find_nodes(chart);
}

CGAL_ANGLE_BASED_FLATTENING_INLINE void find_borders(Chart& chart, int first_border)
{
  std::vector<char> found(chart.vertex.size(), false);
  std::vector<char> on_border(chart.points.size(), false);
  chart.borders.clear();

  auto follow = [&](int start) {
    if(chart.opposite[start] >= 0 || found[start])
      return;
    chart.borders.emplace_back();
    for(int c = start; !found[c]; c = next_on_border(chart, c)) {
      found[c] = true;
      on_border[chart.edge_source(c)] = true;
      chart.borders.back().push_back(c);
    }
  };
  if(first_border >= 0)
    follow(first_border);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    follow(c);

  chart.number_of_interior_vertices = 0;
  chart.interior.resize(chart.points.size());
  for(std::size_t v = 0; v < chart.points.size(); ++v)
    chart.interior[v] = on_border[v] ? -1 : chart.number_of_interior_vertices++;
  find_nodes(chart);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FIND_BORDERS_IMPL_H
