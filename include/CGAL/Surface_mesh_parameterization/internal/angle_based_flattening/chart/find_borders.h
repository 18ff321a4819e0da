// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FIND_BORDERS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FIND_BORDERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The vertices of the outer border that have prescribed angles
inline std::vector<int> vertices_with_prescribed_angles(const Chart& chart)
{
  std::vector<int> vertices;
  if(chart.has_prescribed_angles())
    for(int c : chart.borders.front())
      if(chart.is_angle_prescribed(chart.edge_source(c)))
        vertices.push_back(chart.edge_source(c));
  return vertices;
}

// Whether the whole outer border is prescribed. Then the equations of all vertices sum up to that of all triangles.
inline bool is_whole_border_prescribed(const Chart& chart)
{
  return chart.has_prescribed_angles() &&
         vertices_with_prescribed_angles(chart).size() == chart.borders.front().size();
}

// Makes nodes for the vertices of seams that are inside of the surface before the cut. Their triangles close around them, and so
// they have the equation for lengths (Eq. 4), but none for angles. A closed surface has one equation that follows from all others.
inline void add_seam_nodes(Chart& chart)
{
  // Disjoint sets. Those of Boost do not compile behind some of its headers for graphs, which users may include.
  std::vector<int> parent(chart.points.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto place_of = [&](int v) {
    while(parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  std::vector<char> is_open(chart.points.size(), false), is_on_seam(chart.points.size(), false);
  const auto for_each_border_edge = [&](const auto& visit) {
    for(const std::vector<int>& border : chart.borders)
      for(int c : border)
        visit(c, c < static_cast<int>(chart.seam.size()) ? chart.seam[c] : -1);
  };
  for_each_border_edge([&](int c, int across) {
    if(across >= 0) {
      parent[place_of(chart.edge_source(c))] = place_of(chart.edge_target(across));
      parent[place_of(chart.edge_target(c))] = place_of(chart.edge_source(across));
    }
  });
  bool is_closed = true;
  for_each_border_edge([&](int c, int across) {
    for(int v : {chart.edge_source(c), chart.edge_target(c)})
      (across >= 0 ? is_on_seam : is_open)[place_of(v)] = true;
    is_closed = is_closed && across >= 0;
  });
  std::vector<int> node(chart.points.size(), -1);
  for_each_border_edge([&](int c, int) {
    const int place = place_of(chart.edge_source(c));
    if(!is_on_seam[place] || is_open[place])
      return;
    if(node[place] < 0) {
      node[place] = chart.number_of_nodes();
      chart.nodes.push_back({0, false, true});
    }
    chart.node[chart.edge_source(c)] = node[place];
  });
  if(is_closed)
    chart.nodes.back().has_reconstruction = false;
}

// Makes the interior vertices the constraint nodes, those of seams and those with prescribed angles, and those of the holes.
inline void find_nodes(Chart& chart)
{
  chart.node = chart.interior;
  chart.nodes.assign(chart.number_of_interior_vertices, Constraint_node());
  const auto add_node = [&](int v, const Constraint_node& node) {
    chart.node[v] = chart.number_of_nodes();
    chart.nodes.push_back(node);
  };
  if(chart.has_equal_seams)
    add_seam_nodes(chart);
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

// Finds `borders`, `interior`, `number_of_interior_vertices` and the constraint nodes from `vertex` and `opposite`. The
// first border cycle is the one with the edge that `first_border` faces, if that is not negative; the others are holes.
inline void find_borders(Chart& chart, int first_border = -1)
{
  std::vector<char> found(chart.vertex.size(), false);
  std::vector<char> on_border(chart.points.size(), false);
  chart.borders.clear();

  auto follow = [&](int start) {
    if(found[start] || chart.opposite[start] >= 0)
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

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FIND_BORDERS_H
