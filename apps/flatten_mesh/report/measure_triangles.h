// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_MEASURE_TRIANGLES_H
#define FLATTEN_MESH_MEASURE_TRIANGLES_H

#include "flatten_mesh/report/Wedge_mesh.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_measures.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/measure_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace flatten_mesh {

namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;

// Measures of the distortion of each triangle: NaN without chart, and those that are made from derivatives also without
// area
struct Triangle_measures
{
  std::vector<double>
      angle_change; // mean over the corners, in degrees: what the report calls change of angles, and means by area
  std::vector<double>
      area_change; // binary logarithm of the factor of areas, relative to that of all charts together
  std::vector<double> stretch_ratio; // quasi-conformal ratio
  std::vector<double> areas;         // on the surface, up to a common factor
  double scale = 1;                  // of lengths, from the surface to the plane; 1 for surfaces without area
};

// The triangles of a mesh of wedges as a chart of the package, whose vertices are the wedges. Only points, vertices and
// scale are set.
inline abf::Chart chart_of_wedges(const Wedge_mesh& mesh)
{
  CGAL::Bbox_3 box;
  for(const Kernel::Point_3& p : mesh.points) {
    box += p.bbox();
  }
  abf::Chart chart;
  chart.scale = abf::power_of_two((std::max)({box.x_span(), box.y_span(), box.z_span()}));
  chart.points.reserve(mesh.wedge_points.size());
  for(const Wedge_mesh::Index point : mesh.wedge_points) {
    const Kernel::Point_3& p = mesh.points[point];
    chart.points.emplace_back(p.x() / chart.scale, p.y() / chart.scale, p.z() / chart.scale);
  }
  chart.vertex.reserve(3 * mesh.triangles.size());
  for(const std::array<Wedge_mesh::Index, 3>& triangle : mesh.triangles) {
    chart.vertex.insert(chart.vertex.end(), triangle.begin(), triangle.end());
  }
  return chart;
}

namespace internal {

struct Scaled_plane
{
  std::vector<abf::Chart::Point_2> uv;
  double scale; // a power of two, by which the coordinates are divided
};

inline Scaled_plane scaled_plane(const Wedge_mesh& mesh)
{
  double largest = 0;
  for(const Kernel::Point_2& p : mesh.wedge_uv) {
    if(std::isfinite(p.x())) {
      largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y())});
    }
  }
  Scaled_plane plane{{}, abf::power_of_two(largest)};
  plane.uv.reserve(mesh.wedge_uv.size());
  for(const Kernel::Point_2& p : mesh.wedge_uv) {
    plane.uv.emplace_back(p.x() / plane.scale, p.y() / plane.scale);
  }
  return plane;
}

// From the plane to the surface, both as they are scaled here
inline double scale_of_charts(const Wedge_mesh& mesh, const abf::Chart& chart, const Scaled_plane& plane)
{
  double on_surface = 0, in_plane = 0;
  for(int t = 0; t < chart.number_of_triangles(); ++t) {
    if(mesh.charts[static_cast<std::size_t>(t)] >= 0) {
      on_surface += abf::surface_area(chart, t);
      in_plane += std::abs(abf::planar_area(chart, plane.uv, t));
    }
  }
  const double scale = std::sqrt(on_surface / in_plane);
  return std::isnormal(scale) ? scale : 1;
}

} // namespace internal

inline Triangle_measures measure_triangles(const Wedge_mesh& mesh)
{
  const double none = std::numeric_limits<double>::quiet_NaN();
  abf::Chart chart = chart_of_wedges(mesh);
  chart.targets.assign(chart.vertex.size(), 1); // of the energy, which is not asked for
  const internal::Scaled_plane plane = internal::scaled_plane(mesh);
  const double scale = internal::scale_of_charts(mesh, chart, plane);
  const abf::Target_angles targets(chart);
  const std::size_t triangles = mesh.triangles.size();
  Triangle_measures measures;
  measures.scale = plane.scale / chart.scale / scale;
  for(std::vector<double>* values :
      {&measures.angle_change, &measures.area_change, &measures.stretch_ratio, &measures.areas}) {
    values->resize(triangles);
  }
  abf::parallel_for_blocks(static_cast<int>(triangles), [&](const int begin, const int end) {
    for(int t = begin; t < end; ++t) {
      const auto i = static_cast<std::size_t>(t);
      const CGAL::Surface_mesh_parameterization::Flattening_face_measures face =
          abf::measure_triangle(chart, targets, plane.uv, scale, t);
      const bool has_area = face.scale > 0;
      measures.angle_change[i] = face.mean_angle_change * 180 / CGAL_PI;
      measures.area_change[i] = has_area ? 2 * std::log2(face.scale) : none;
      measures.stretch_ratio[i] = has_area ? face.quasi_conformal_ratio : none;
      measures.areas[i] = mesh.charts[i] < 0 ? 0 : face.area;
    }
  });
  return measures;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_MEASURE_TRIANGLES_H
