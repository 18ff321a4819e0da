// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Points of the plane, and the angles of triangles there, of any orientation. The certificate, the measures of
// distortion, and the stages that move vertices in the plane take the angles of a map from here.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_PLANAR_ANGLE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_PLANAR_ANGLE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

typedef Eigen::Vector2d Planar_point;
typedef std::array<Planar_point, 3> Planar_triangle; // its corners

inline double cross(const Planar_point& a, const Planar_point& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

// Whether `p` lies in direction [0, pi) from `origin`, and not in [pi, 2 pi).
template <typename Point>
bool is_in_upper_half(const Point& p, const Point& origin)
{
  return p.y() == origin.y() ? p.x() > origin.x() : p.y() > origin.y();
}

// The angle of a vector with positive coordinates: `std::atan2(sine, cosine)` up to 2^-50 of it, in half the time. It
// is an angle whose tangent is a multiple of 1/8 plus a remainder, of which six terms of the series are enough.
inline double acute_angle(double sine, double cosine)
{
  constexpr double known[] = {0,
                              0.12435499454676144,
                              0.24497866312686414,
                              0.3587706702705722,
                              0.4636476090008061,
                              0.5585993153435624,
                              0.6435011087932844,
                              0.7188299996216245,
                              0.7853981633974483};
  const bool is_steep = sine > cosine;
  const double y = is_steep ? cosine : sine, x = is_steep ? sine : cosine, tangent = y / x;
  if(!(tangent >= 0 && tangent <= 1))
    return std::atan2(sine, cosine);
  const int i = static_cast<int>(8 * tangent + 0.5);
  const double base = 0.125 * i, r = (y - base * x) / (x + base * y), s = r * r;
  const double angle =
      known[i] + (r - r * s * (1. / 3 - s * (1. / 5 - s * (1. / 7 - s * (1. / 9 - s * (1. / 11))))));
  return is_steep ? pi / 2 - angle : angle;
}

// The angles of a triangle in the plane, from twice its area, which is positive, and the dot products of the edges at
// its corners. The largest one is the rest of pi, and needs no arc tangent.
inline std::array<double, 3> planar_angles(double twice_area, const std::array<double, 3>& dots)
{
  const int k = static_cast<int>(std::min_element(dots.begin(), dots.end()) - dots.begin());
  std::array<double, 3> alpha;
  alpha[(k + 1) % 3] = acute_angle(twice_area, dots[(k + 1) % 3]);
  alpha[(k + 2) % 3] = acute_angle(twice_area, dots[(k + 2) % 3]);
  alpha[k] = pi - alpha[(k + 1) % 3] - alpha[(k + 2) % 3];
  return alpha;
}

inline std::array<double, 3> planar_angles(const Planar_triangle& x)
{
  const Planar_point a = x[1] - x[0], b = x[2] - x[0], c = x[2] - x[1];
  return planar_angles(cross(a, b), {a.dot(b), -a.dot(c), b.dot(c)});
}

// Sine and cosine of the angle at corner `c` in the plane, regardless of orientation, times the lengths of its edges
inline std::pair<double, double> scaled_sine_and_cosine(const Corner_table& chart,
                                                        const std::vector<Corner_table::Point_2>& uv, int c)
{
  const Corner_table::Point_2& p = uv[chart.vertex[c]];
  const auto a = uv[chart.vertex[next_corner(c)]] - p;
  const auto b = uv[chart.vertex[previous_corner(c)]] - p;
  return {std::abs(CGAL::determinant(a, b)), a * b};
}

// The angle at corner `c` in the plane, regardless of orientation.
inline double planar_angle(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv, int c)
{
  const auto [sine, cosine] = scaled_sine_and_cosine(chart, uv, c);
  return std::atan2(sine, cosine);
}

// The one with the largest cotangent.
inline double smallest_angle(const Corner_table& chart, const std::vector<Corner_table::Point_2>& uv)
{
  double largest = -(std::numeric_limits<double>::infinity)();
  int corner = -1;
  for(int c = 0; c < chart.number_of_corners(); ++c) {
    const auto [sine, cosine] = scaled_sine_and_cosine(chart, uv, c);
    const double cotangent =
        sine == 0 && cosine == 0 ? (std::numeric_limits<double>::infinity)() : cosine / sine;
    if(cotangent > largest) {
      largest = cotangent;
      corner = c;
    }
  }
  return corner < 0 ? pi : planar_angle(chart, uv, corner);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_PLANAR_ANGLE_H
