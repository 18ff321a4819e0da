// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The certificate of a flattened chart: whether any triangle is flipped, whether vertices are wound once, and whether
// the border is simple. The methods of `strategies/` call `certify()` on rounded coordinates before they report
// success.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_CERTIFY_CHART_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_CERTIFY_CHART_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The final check of coordinates from any method: orientations, by exact predicates, the border, and the sizes of
// triangles
struct Certificate
{
  std::vector<int> invalid; // the triangles that make the map invalid
  int flipped_triangles = 0;
  bool border_is_simple = false;
  double smallest_angle = 0;
  double scale_range = 1;

  bool is_valid() const { return invalid.empty(); }
};

// The triangles around interior vertices with another winding number than one, although none is flipped.
inline std::vector<int> multiply_wound_triangles(const Corner_table& chart,
                                                 const std::vector<Exact_point_2>& uv)
{
  const std::vector<int> winding = winding_numbers(chart.vertex, uv);
  std::vector<int> wound;
  for(int c = 0; c < chart.number_of_corners(); ++c)
    if(const int v = chart.vertex[c]; chart.interior[v] >= 0 && winding[v] != 1)
      if(wound.empty() || wound.back() != c / 3)
        wound.push_back(c / 3);
  return wound;
}

inline bool is_valid_map(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv)
{
  const std::vector<Exact_point_2> points = exact_points(uv);
  return flipped_triangles(chart.vertex, points).empty() && multiply_wound_triangles(chart, points).empty();
}

// The first two members of a certificate, also of coordinates that are not finite
inline Certificate certify_triangles(const Corner_table& chart, const std::vector<Exact_point_2>& points)
{
  Certificate certificate;
  certificate.invalid = flipped_triangles(chart.vertex, points);
  certificate.flipped_triangles = static_cast<int>(certificate.invalid.size());
  if(certificate.invalid.empty())
    certificate.invalid = multiply_wound_triangles(chart, points);
  return certificate;
}

inline Certificate certify(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv)
{
  const std::vector<Exact_point_2> points = exact_points(uv);
  Certificate certificate = certify_triangles(chart, points);
  certificate.border_is_simple = is_border_simple(chart, points);
  certificate.smallest_angle = smallest_angle(chart, uv);
  certificate.scale_range = scale_range(chart, uv);
  return certificate;
}

// What makes the map invalid, as the end of a sentence
inline std::string describe_invalid(const Corner_table& chart, const Certificate& certificate)
{
  return std::to_string(certificate.invalid.size()) +
         (certificate.flipped_triangles > 0 ? " flipped triangle(s)"
                                            : " triangle(s) that wind around a vertex more than once") +
         ", one at " + vertex_text(chart, chart.vertex[3 * certificate.invalid.front()]);
}

// Where the border of a map touches itself, as the end of a sentence
inline std::string describe_touching_edges(const Corner_table& chart,
                                           const std::vector<Corner_table::Point_2>& uv)
{
  const std::vector<std::pair<int, int>> pairs = border_crossings(chart, uv);
  if(pairs.empty())
    return "holes that are not inside the outer border, or borders inside one another";
  return std::to_string(pairs.size()) + " pair(s) of border edges that touch, one at " +
         vertex_text(chart, chart.edge_source(pairs.front().first));
}

inline void take_certificate(const Certificate& certificate, Flattening_report& report)
{
  report.flipped_triangles = certificate.flipped_triangles;
  report.border_is_simple = certificate.border_is_simple;
  report.smallest_angle = certificate.smallest_angle;
  report.scale_range = certificate.scale_range;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_CERTIFY_CHART_H
