// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_SHAPE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_SHAPE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Whether a vertex is prescribed to be inside of a straight side
inline bool is_on_straight_side(const Chart& chart, int v)
{
  return chart.is_angle_prescribed(v) && std::abs(chart.angle_sums[v] - pi) <= 1e-12;
}

// The largest difference between a prescribed angle and that of the map
inline double largest_angle_error(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  std::vector<double> sum(chart.points.size(), 0.);
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(chart.is_angle_prescribed(chart.vertex[c]))
      sum[chart.vertex[c]] += planar_angle(chart, uv, c);
  double largest = 0;
  for(int v : vertices_with_prescribed_angles(chart))
    largest = (std::max)(largest, std::abs(sum[v] - chart.angle_sums[v]));
  return largest;
}

// The largest distance of a vertex from the line through the ends of its straight side, relative to the distance of these ends
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

// The largest difference between the logarithms of the lengths of both sides of an edge on a seam
inline double largest_seam_jump(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  const auto squared_length = [&](int c) {
    return CGAL::squared_distance(uv[chart.edge_source(c)], uv[chart.edge_target(c)]);
  };
  double largest = 0;
  for(std::size_t c = 0; c < chart.seam.size(); ++c)
    if(const int across = chart.seam[c]; across > static_cast<int>(c))
      largest = (std::max)(
          largest, std::abs(std::log(squared_length(static_cast<int>(c)) / squared_length(across))) / 2);
  return largest;
}

// Reports how well a map keeps to the prescribed angles.
inline void report_prescribed_angles(const Chart& chart, const std::vector<Chart::Point_2>& uv,
                                     ABF_plus_plus_report& report)
{
  if(!chart.has_prescribed_angles())
    return;
  report.prescribed_angles = static_cast<int>(vertices_with_prescribed_angles(chart).size());
  report.largest_angle_error = largest_angle_error(chart, uv);
  report.side_deviation = side_deviation(chart, uv);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_BORDER_SHAPE_H
