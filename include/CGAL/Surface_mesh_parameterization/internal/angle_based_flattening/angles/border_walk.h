// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The edges of a border in the plane, as the angles alone determine them: by turns at the vertices, and the sine rule.
// Holes and seams need it for their equations (`hole_equations.h`, `loop_equations.h`), and the layout to place the
// border.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_BORDER_WALK_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_BORDER_WALK_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A directed edge in the plane
struct Planar_edge
{
  double direction = 0, log_length = 0;
};

// The edges of a planar border, that the angles alone determine up to a similarity. The last one is the first one
// again, after a turn around the border.
typedef std::vector<Planar_edge> Border_walk;

// At a vertex the border turns by pi less the angles there, and its edges' lengths are related by the sine rule through
// the fan.
inline Border_walk walk_along_border(const Chart& chart, const std::vector<double>& alpha,
                                     const std::vector<int>& border, Planar_edge edge = {})
{
  Border_walk walk;
  walk.reserve(border.size() + 1);
  walk.push_back(edge);
  for(int first : border) {
    edge.direction += pi;
    for(int c = previous_corner(first); c >= 0; c = chart.rotate(c)) {
      edge.direction -= alpha[c];
      edge.log_length += std::log(std::sin(alpha[previous_corner(c)]) / std::sin(alpha[next_corner(c)]));
    }
    walk.push_back(edge);
  }
  return walk;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_BORDER_WALK_H
