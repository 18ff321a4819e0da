// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Walks around all vertices of a chart, and counts its handles and borders.
// These are the bodies of `diagnose.h`, which the compiled library has.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_DIAGNOSE_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_DIAGNOSE_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <cmath>
#include <string>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect find_non_finite_point(const Chart& chart)
{
  for(int v = 0; v < chart.number_of_vertices(); ++v)
    for(int i = 0; i < 3; ++i)
      if(!std::isfinite(chart.points[v][i]))
        return {Diagnosis::NON_FINITE_POINT, vertex_text(chart, v) + non_finite_text, {v}, {}};
  return {};
}

// Each component of the normal is compared with how much it changes if coordinates change by their last digit: where
// one axis has much smaller coordinates than others, so are its errors.
CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<int> degenerate_triangles(const Chart& chart)
{
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const auto is_degenerate = [&](int t) {
    const Chart::Point_3& p = chart.points[chart.vertex[3 * t]];
    double side[2][3], error[2][3];
    for(int k = 0; k < 2; ++k)
      for(int i = 0; i < 3; ++i) {
        const double x = chart.points[chart.vertex[3 * t + k + 1]][i];
        side[k][i] = x - p[i];
        error[k][i] = epsilon * (std::abs(x) + std::abs(p[i]));
      }
    for(int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      double bound = 0;
      for(const auto& [a, b] : {std::pair(i, j), std::pair(j, i)})
        bound += std::abs(side[0][a]) * error[1][b] + error[0][a] * std::abs(side[1][b]) +
                 error[0][a] * error[1][b];
      if(std::abs(side[0][i] * side[1][j] - side[0][j] * side[1][i]) > bound)
        return false;
    }
    return true;
  };
  std::vector<int> result;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    if(is_degenerate(t))
      result.push_back(t);
  return result;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect find_no_area(const Chart& chart, std::vector<int> degenerate)
{
  if(static_cast<int>(degenerate.size()) < chart.number_of_triangles())
    return {};
  const std::string text = "the surface has no area: all " + std::to_string(degenerate.size()) +
                           " triangles are degenerate, with the vertices on a line or at a point";
  return {Diagnosis::NO_AREA, text, {}, std::move(degenerate)};
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect find_bad_vertex(const Chart& chart)
{
  std::vector<char> walked(chart.vertex.size(), false);
  std::vector<char> has_fan(chart.points.size(), false);
  std::vector<int> neighbour_of(chart.points.size(), -1); // the last vertex that met this one as a neighbour

  auto walk = [&](int first) -> Chart_defect {
    const int v = chart.vertex[first];
    if(has_fan[v])
      return {Diagnosis::NON_MANIFOLD_VERTEX,
              "the surface is pinched at " + vertex_text(chart, v) + ": its triangles form more than one fan",
              {v},
              {}};
    has_fan[v] = true;
    auto meet = [&](int w) {
      const bool again = w == v || neighbour_of[w] == v;
      neighbour_of[w] = v;
      return again;
    };
    int c = first;
    do {
      walked[c] = true;
      int w = chart.vertex[previous_corner(c)];
      bool again = meet(w);
      const int next = chart.rotate(c);
      if(next < 0 && !again)
        again = meet(w = chart.vertex[next_corner(c)]);
      if(again)
        return {Diagnosis::PARALLEL_EDGES,
                "two edges, or a loop, join " + vertex_text(chart, v) + " and " + vertex_text(chart, w) +
                    ": a planar triangulation has at most one edge between two vertices",
                {v, w},
                {c / 3}};
      c = next;
    } while(c >= 0 && c != first);
    return {};
  };

  for(const std::vector<int>& border : chart.borders)
    for(int c : border)
      if(Chart_defect defect = walk(previous_corner(c)))
        return defect;
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(!walked[c])
      if(Chart_defect defect = walk(c))
        return defect;
  return {};
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect find_wrong_topology(const Chart& chart, bool with_holes)
{
  int border_edges = 0;
  for(const std::vector<int>& border : chart.borders)
    border_edges += static_cast<int>(border.size());
  const int edges = (chart.number_of_corners() - border_edges) / 2 + border_edges;
  const int borders = static_cast<int>(chart.borders.size());
  const int twice_genus = 2 - borders - (chart.number_of_vertices() - edges + chart.number_of_triangles());
  if(twice_genus != 0)
    return {Diagnosis::NONZERO_GENUS,
            "the surface has " + std::to_string(twice_genus / 2) +
                " handle(s): cut it open to a disk first, for example by select_seams()",
            {},
            {}};
  if(borders > 1 && !with_holes) {
    const int v = chart.edge_source(chart.borders[1].front());
    return {Diagnosis::SEVERAL_BORDERS,
            "the surface has " + std::to_string(borders) + " borders, a second one at " +
                vertex_text(chart, v) + ", and holes are refused",
            {v},
            {}};
  }
  return {};
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect diagnose(const Chart& chart, bool with_holes)
{
  if(Chart_defect defect = find_non_finite_point(chart))
    return defect;
  if(Chart_defect defect = find_bad_vertex(chart))
    return defect;
  return find_wrong_topology(chart, with_holes);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_DIAGNOSE_IMPL_H
