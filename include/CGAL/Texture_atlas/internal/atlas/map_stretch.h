// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// How much a map stretches a chart as a whole, and around each vertex. The makers of parts compare maps by it,
// `reduce_stretch.h` finds the next ends of seams, and `certify_atlas.h` reports it.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MAP_STRETCH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MAP_STRETCH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_differential.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// A map may exceed the bound of `select_seams()` by this factor, because the prediction is for a smooth surface.
inline constexpr double stretch_tolerance = 1.03;

// How much a map stretches a chart, or a piece of one
struct Map_stretch
{
  double scale =
      1; // due to its scale. Unlike the L2 stretch, seams can lower it wherever long thin triangles are.
  double l2 = 1;
  double ordinary_l2 = 1; // without needles, whose shape is mostly rounding
  int crushed_triangles = 0;
  double skewed_share = 0; // of the area
  double length = 0;       // of the diagonal of its box, in the units of the surface

  // Whether the chart is not good. An infinite bound accepts any stretch.
  bool is_bad(double bound) const { return exceeds(l2, bound); }

  // Whether another map might be better. Needles stretch alike in all maps.
  bool is_mendable(double bound) const { return exceeds(ordinary_l2, bound); }

private:
  static constexpr double most_skewed = 0.01;

  bool exceeds(double stretch, double bound) const
  {
    return stretch > (std::max)(2., bound) ||
           ((crushed_triangles > 0 || skewed_share > most_skewed) && std::isfinite(bound));
  }
};

// The sums over triangles that the stretch is made of
class Stretch_sums
{
public:
  void add(const Chart& chart, const std::vector<Chart::Point_2>& uv, int t)
  {
    const double surface = surface_area(chart, t), plane = std::abs(planar_area(chart, uv, t));
    m_surface += surface;
    m_plane += plane;
    for(int c = 3 * t; c < 3 * t + 3; ++c)
      m_box += uv[chart.vertex[c]].bbox();
    if(!(surface > 0))
      return; // infinity times 0 would be NaN
    m_scale += surface * surface / plane;
    const Triangle_differential map(chart, uv, t);
    double squares = 0;
    if(map.has_area())
      squares = surface * (CGAL::square(map.largest_stretch()) + CGAL::square(map.smallest_stretch())) / 2;
    else if(std::isnormal(surface))
      squares = std::numeric_limits<double>::infinity();
    m_squares += squares;
    if(!is_needle(chart, t)) {
      m_ordinary_squares += squares;
      m_crushed += map.is_thinner(largest_ratio);
      m_skewed += map.is_thinner(skewed_ratio) ? surface : 0;
    }
  }

  double surface() const { return m_surface; }
  double plane() const { return m_plane; }

  Map_stretch stretch() const
  {
    Map_stretch result;
    if(m_surface > 0) {
      result.scale = (std::max)(1., std::sqrt(m_scale * m_plane) / m_surface); // but for rounding
      result.l2 = std::sqrt(m_squares / m_surface * (m_plane / m_surface));
      result.ordinary_l2 = std::sqrt(m_ordinary_squares / m_surface * (m_plane / m_surface));
      result.length = std::hypot(m_box.x_span(), m_box.y_span()) * std::sqrt(m_surface / m_plane);
    }
    result.crushed_triangles = m_crushed;
    result.skewed_share = m_surface > 0 ? m_skewed / m_surface : 0;
    return result;
  }

private:
  double m_surface = 0, m_plane = 0, m_scale = 0, m_squares = 0, m_ordinary_squares = 0, m_skewed = 0;
  int m_crushed = 0;
  Bbox_2 m_box;
};

inline Map_stretch map_stretch(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  Stretch_sums sums;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    sums.add(chart, uv, t);
  return sums.stretch();
}

// The scale of a map around a vertex
struct Vertex_scale
{
  double area = 0;      // of the triangles around it, on the surface
  double log_scale = 0; // logarithm of the factor of lengths, relative to the mean

  // How much this vertex adds to the stretch. It is large where large triangles have a moderate scale.
  double stretch_by_area() const { return area * (std::cosh(2 * log_scale) - 1); }
};

// The scale at each vertex of the surface that was cut open to the chart; `origin` is the vertex of the surface for
// each vertex of the chart.
inline std::vector<Vertex_scale> vertex_scales(const Chart& chart, const std::vector<Chart::Point_2>& uv,
                                               const std::vector<int>& origin, int number_of_vertices)
{
  std::vector<Vertex_scale> scales(number_of_vertices);
  std::vector<double> plane(number_of_vertices, 0.);
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    for(int k = 0; k < 3; ++k) {
      const int v = origin[chart.vertex[3 * t + k]];
      scales[v].area += surface_area(chart, t);
      plane[v] += std::abs(planar_area(chart, uv, t));
    }
  double mean = 0, total = 0;
  for(int v = 0; v < number_of_vertices; ++v)
    if(scales[v].area > 0 && plane[v] > 0) {
      scales[v].log_scale = std::log(plane[v] / scales[v].area) / 2;
      mean += scales[v].area * scales[v].log_scale;
      total += scales[v].area;
    }
  for(int v = 0; v < number_of_vertices; ++v)
    if(scales[v].area > 0 && plane[v] > 0)
      scales[v].log_scale -= mean / total;
  return scales;
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_MAP_STRETCH_H
