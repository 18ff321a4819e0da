// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How well a map satisfies what was prescribed for its border: angles, straight sides, and equal lengths on both sides
// of seams. The methods of `strategies/` and `certify_atlas.h` put it into their reports.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_SHAPE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_SHAPE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/seam_nodes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Whether a vertex is prescribed to be inside of a straight side
inline bool is_on_straight_side(const Chart& chart, int v)
{
  return chart.is_angle_prescribed(v) && std::abs(chart.angle_sums[v] - pi) <= 1e-12;
}

inline int number_of_prescribed_angles(const std::vector<double>& prescribed, const std::vector<int>& place)
{
  std::vector<char> has_angle(place.size(), false);
  for(std::size_t v = 0; v < prescribed.size(); ++v)
    if(std::isfinite(prescribed[v]))
      has_angle[place[v]] = true;
  return static_cast<int>(std::count(has_angle.begin(), has_angle.end(), true));
}

// The largest difference between a prescribed angle and the angle in the map. `sums` belong to all copies of a vertex
// together, as `place` identifies them.
inline double largest_angle_error(const std::vector<double>& prescribed, const std::vector<double>& sums,
                                  const std::vector<int>& place)
{
  double largest = 0;
  for(std::size_t v = 0; v < prescribed.size(); ++v)
    if(std::isfinite(prescribed[v]))
      largest = (std::max)(largest, std::abs(sums[place[v]] - prescribed[v]));
  return largest;
}

// The sum of the planar angles at each place
inline std::vector<double> planar_angle_sums(const Chart& chart, const std::vector<Chart::Point_2>& uv,
                                             const std::vector<int>& place)
{
  std::vector<double> sums(chart.points.size(), 0.);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(chart.interior[chart.vertex[c]] < 0)
      sums[place[chart.vertex[c]]] += planar_angle(chart, uv, c);
  return sums;
}

// The largest distance of a vertex from the line through the ends of its straight side, relative to the distance of
// these ends
inline double side_deviation(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  std::vector<int> vertices;
  for(int c : chart.borders.front())
    vertices.push_back(chart.edge_source(c));
  const auto corner =
      std::find_if(vertices.begin(), vertices.end(), [&](int v) { return !is_on_straight_side(chart, v); });
  std::rotate(vertices.begin(), corner, vertices.end());
  vertices.push_back(vertices.front());
  double largest = 0;
  for(std::size_t first = 0, last; first + 1 < vertices.size(); first = last) {
    for(last = first + 1; last + 1 < vertices.size() && is_on_straight_side(chart, vertices[last]);)
      ++last;
    const auto side = uv[vertices[last]] - uv[vertices[first]];
    for(std::size_t i = first + 1; i < last; ++i)
      largest = (std::max)(largest, std::abs(CGAL::determinant(side, uv[vertices[i]] - uv[vertices[first]])) /
                                        side.squared_length());
  }
  return largest;
}

// The difference between the logarithms of the lengths of both sides of an edge on a seam, one of which the corner
// faces
inline double seam_jump(const Chart& chart, const std::vector<Chart::Point_2>& uv, int c)
{
  const auto length = [&](int corner) {
    const auto side = uv[chart.edge_target(corner)] - uv[chart.edge_source(corner)];
    return std::hypot(side.x(), side.y());
  };
  return std::abs(std::log(length(c) / length(chart.seam[c])));
}

// The largest one of a chart
inline double largest_seam_jump(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  double largest = 0;
  for(int c = 0; c < static_cast<int>(chart.seam.size()); ++c)
    if(chart.seam[c] > c)
      largest = (std::max)(largest, seam_jump(chart, uv, c));
  return largest;
}

// The largest difference between a full turn and the sum of angles at a vertex in the middle of a seam that is not a
// cone. By this angle, the two sides of the seam turn differently from one edge to the next.
inline double largest_seam_turn(const Chart& chart, const Seam_places& places,
                                const std::vector<double>& sums)
{
  double largest = 0;
  for(int c : chart.borders.front()) {
    const int v = chart.edge_source(c), place = places.of(v);
    const bool is_cone = !chart.surface_sums.empty() && !std::isnan(chart.surface_sums[v]);
    if(!is_cone && places.is_inside(place) && places.copies(place) > 1)
      largest = (std::max)(largest, std::abs(sums[place] - 2 * pi));
  }
  return largest;
}

// Fills the part of a report that is about seams.
inline void report_seams(const Chart& chart, const std::vector<Chart::Point_2>& uv,
                         ABF_plus_plus_report& report)
{
  if(chart.seam.empty())
    return;
  const Seam_places places(chart);
  report.largest_seam_jump = largest_seam_jump(chart, uv);
  report.largest_seam_turn =
      largest_seam_turn(chart, places, planar_angle_sums(chart, uv, places.of_vertices()));
}

// Fills the part about prescribed angles. Angles of the border belong to each copy of a vertex by itself.
inline void report_prescribed_angles(const Chart& chart, const std::vector<Chart::Point_2>& uv,
                                     ABF_plus_plus_report& report)
{
  if(!chart.has_prescribed_angles())
    return;
  std::vector<int> place(chart.points.size());
  std::iota(place.begin(), place.end(), 0);
  if(!chart.has_prescribed_border())
    place = Seam_places(chart).of_vertices();
  const std::vector<double>& angles = chart.has_prescribed_border() ? chart.angle_sums : chart.surface_sums;
  report.prescribed_angles = number_of_prescribed_angles(angles, place);
  report.largest_angle_error = largest_angle_error(angles, planar_angle_sums(chart, uv, place), place);
  if(chart.has_prescribed_border())
    report.side_deviation = side_deviation(chart, uv);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_SHAPE_H
