// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The four equations that close the surface around a hole: rotation, scale and translation. The paper flattens disks
// and has none. In `constraints.h` they replace the equations of the hole's vertices, and the exact layout walks around
// holes with them.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_HOLE_EQUATIONS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_HOLE_EQUATIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_angle_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The four equations of a hole. The equations of interior vertices (Eqs. 3 and 4) close the triangles around each
// vertex, but not around a hole. Around a hole of m vertices, these equations hold:
//   rotation: the angles around the hole sum to (m + 2) pi
//   scale: the logarithms of the ratios of its edges' lengths sum to 0
//   translation, in both coordinates: its edges sum to 0
struct Hole_equations
{
  typedef std::complex<double> Complex;

  double rotation = 0, scale = 0; // by how much these equations are off
  Complex gap;                    // relative to the hole's circumference
  // Of each vertex, relative to the centre of the hole. They are the gap's derivative: it changes by the sum of q
  // (len + i plan) over all vertices, where plan and len are the changes of the sums in Eqs. 3 and 4.
  std::vector<Complex> positions;
};

// The edges of a hole on the surface, whose lengths sum to 1
struct Hole_edges
{
  std::vector<double> length;
  std::vector<double> middle; // of each edge: how far its middle is from that of the first one
};

inline Hole_edges hole_edges(const Chart& chart, const std::vector<int>& hole)
{
  Hole_edges edges;
  for(int c : hole)
    edges.length.push_back(edge_length(chart, c));
  double circumference = std::accumulate(edges.length.begin(), edges.length.end(), 0.);
  if(!(circumference > 0)) {
    edges.length.assign(hole.size(), 1);
    circumference = static_cast<double>(hole.size());
  }
  double source = -edges.length.front() / 2;
  for(double& length : edges.length) {
    edges.middle.push_back((source + length / 2) / circumference);
    source += length;
    length /= circumference;
  }
  return edges;
}

// Walks around a hole, over edges that compensate the defects of rotation and scale: each edge is turned and scaled in
// proportion to its part of the way. If the hole closes, these edges are the same as the others, but their gap is
// closer to linear: without the defects, it shows only how the hole moves apart.
inline Border_walk walk_around_hole(const Chart& chart, const std::vector<double>& alpha,
                                    const std::vector<int>& hole, const Hole_edges& surface,
                                    Hole_equations& equations, const Planar_edge& first_edge = {})
{
  Border_walk walk = walk_along_border(chart, alpha, hole, first_edge);
  // It turns the other way round than the outer border.
  equations.rotation = first_edge.direction - 2 * pi - walk.back().direction;
  equations.scale = first_edge.log_length - walk.back().log_length;
  for(std::size_t j = 0; j < hole.size(); ++j) {
    walk[j].direction += surface.middle[j] * equations.rotation;
    walk[j].log_length += surface.middle[j] * equations.scale;
  }
  return walk;
}

// The logarithm of a hole's circumference in the plane, from the geometric mean of its edges' scales: a single edge
// that grows long must not make the gap of all others small.
inline double log_circumference(const Border_walk& walk, const Hole_edges& surface)
{
  double sum = 0;
  for(std::size_t j = 0; j < surface.length.size(); ++j)
    if(surface.length[j] > 0)
      sum += surface.length[j] * (walk[j].log_length - std::log(surface.length[j]));
  return sum;
}

inline Hole_equations hole_equations(const Chart& chart, const std::vector<double>& alpha,
                                     const std::vector<int>& hole)
{
  typedef Hole_equations::Complex Complex;
  const Hole_edges surface = hole_edges(chart, hole);
  Hole_equations equations;
  const Border_walk walk = walk_around_hole(chart, alpha, hole, surface, equations);
  const double log_unit = log_circumference(walk, surface);
  Complex centre = 0; // that of the vertices, each with half of its edges' lengths as weight
  for(std::size_t j = 0; j < hole.size(); ++j) {
    equations.positions.push_back(equations.gap);
    const Complex edge = std::polar(std::exp(walk[j].log_length - log_unit), walk[j].direction);
    equations.gap += edge;
    centre += (1 - surface.middle[j]) * edge;
  }
  equations.positions.front() = equations.gap; // the walk turns there at its end
  for(Complex& position : equations.positions)
    position -= centre;
  return equations;
}

// Those of all holes
inline std::vector<Hole_equations> hole_equations(const Chart& chart, const std::vector<double>& alpha)
{
  std::vector<Hole_equations> holes(chart.number_of_holes());
  parallel_for(chart.number_of_holes(),
               [&](int k) { holes[k] = hole_equations(chart, alpha, chart.hole(k)); });
  return holes;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_HOLE_EQUATIONS_H
