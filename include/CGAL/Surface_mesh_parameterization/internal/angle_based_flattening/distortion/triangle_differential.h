// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The derivatives of a map on one triangle, and what follows from them: the metric (Eq. 23), shear (Eq. 24) and
// stretch. `measure_chart.h` and `map_stretch.h` sum these up. Injective maps and the atlas find crushed triangles with
// it. The derivatives of the inverse map are for energies (`triangle_energies.h`).

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_TRIANGLE_DIFFERENTIAL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_TRIANGLE_DIFFERENTIAL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The derivatives of the map from the plane to the surface on triangle `t`, in an orthonormal basis of its plane in
// space. They are multiplied by the determinant of the planar edges, so measures that do not depend on scale need no
// division.
//
// The singular values are computed from the norms of the conformal and the anticonformal part of the map: these are
// half the sum and half the difference of the singular values. The eigenvalues of the first fundamental form would
// lose half of the digits where they are nearly equal, as they usually are here.
class Triangle_differential
{
  typedef Chart::Kernel::Vector_2 Vector_2;

public:
  Triangle_differential(const Chart& chart, const std::vector<Chart::Point_2>& uv, int t)
      : m_twice_area(2 * surface_area(chart, t))
  {
    const int* v = &chart.vertex[3 * t];
    const Vector_2 p = uv[v[1]] - uv[v[0]], q = uv[v[2]] - uv[v[0]];
    m_determinant = std::abs(CGAL::determinant(p, q));
    if(!has_area())
      return;
    const auto edge = chart.points[v[1]] - chart.points[v[0]];
    const double length = std::sqrt(edge.squared_length());
    const double along = edge * (chart.points[v[2]] - chart.points[v[0]]) / length;
    const double across = m_twice_area / length;
    m_u = Vector_2(length * q.y() - along * p.y(), -across * p.y());
    m_v = Vector_2(along * p.x() - length * q.x(), across * p.x());
    m_conformal = std::hypot(m_u.x() + m_v.y(), m_u.y() - m_v.x()) / 2;
    m_anticonformal = std::hypot(m_u.x() - m_v.y(), m_u.y() + m_v.x()) / 2;
  }

  // Whether the triangle has area in space and in the plane. Otherwise the other functions are meaningless.
  bool has_area() const { return std::isnormal(m_twice_area) && std::isnormal(m_determinant); }

  double shear() const
  {
    return std::abs(m_u * m_v) / (std::sqrt(m_u.squared_length()) * std::sqrt(m_v.squared_length()));
  }

  double principal_shear() const
  {
    return 2 * m_conformal * m_anticonformal / (CGAL::square(m_conformal) + CGAL::square(m_anticonformal));
  }

  double equal_stretch_error() const
  {
    const double u = m_u.squared_length(), v = m_v.squared_length();
    return std::abs(u - v) / (u + v);
  }

  double largest_stretch() const { return (m_conformal + m_anticonformal) / m_determinant; }

  double smallest_stretch() const // from the product of both, without cancellation
  {
    return (std::min)(area_stretch() / largest_stretch(), largest_stretch());
  }

  // Whether the quasi-conformal ratio is larger than this
  bool is_thinner(double ratio) const
  {
    return !has_area() || largest_stretch() > ratio * smallest_stretch();
  }

  double area_stretch() const { return m_twice_area / m_determinant; }

private:
  double m_twice_area, m_determinant;
  Vector_2 m_u, m_v;
  double m_conformal = 0, m_anticonformal = 0;
};

// Triangles are needles on the surface, and crushed in the plane, if they are so many times as long as thin: if the
// quasi-conformal ratio of the map from an equilateral triangle, or from the surface, is larger.
inline constexpr double largest_ratio = 1000;

// From this quasi-conformal ratio on, a triangle that is no needle is skewed.
inline constexpr double skewed_ratio = 5;

// Also a triangle without area
inline bool is_needle(const Chart& chart, int t)
{
  double squares = 0; // of the lengths of the edges
  for(int c = 3 * t; c < 3 * t + 3; ++c)
    squares += CGAL::square(edge_length(chart, c));
  // the ratio and its inverse add up to squares / (2 sqrt(3) area)
  return !(squares <= largest_ratio * 2 * std::sqrt(3.) * surface_area(chart, t)) || squares == 0;
}

// What happens to needles is due to their shape.
inline bool is_crushed(const Chart& chart, const std::vector<Chart::Point_2>& uv, int t)
{
  if(is_needle(chart, t))
    return false;
  return Triangle_differential(chart, uv, t).is_thinner(largest_ratio);
}

inline bool has_crushed_triangles(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    if(is_crushed(chart, uv, t))
      return true;
  return false;
}

// A triangle of the surface: the gradient of the function that is 1 at a corner and 0 at the others, in an orthonormal
// frame of the triangle
struct Flat_triangle
{
  std::array<Eigen::Vector2d, 3> gradient;
  double area = 0;

  // Triangles of less than `least_area` count as larger ones, so that they still resist being turned over.
  Flat_triangle(const Chart& chart, int t, double least_area)
  {
    const Chart::Point_3& origin = chart.points[chart.vertex[3 * t]];
    const Chart::Kernel::Vector_3 a = chart.points[chart.vertex[3 * t + 1]] - origin,
                                  b = chart.points[chart.vertex[3 * t + 2]] - origin;
    const double aa = a.squared_length(), bb = b.squared_length(), ab = a * b;
    Eigen::Vector2d p(std::sqrt(aa), 0), q(0, std::sqrt(bb));
    if(aa > 0)
      q = Eigen::Vector2d(ab, std::sqrt(CGAL::cross_product(a, b).squared_length())) / p.x();
    // The height of a needle is bounded, so that the gradients are finite.
    q.y() = (std::max)(q.y(), 1e-6 * (aa + bb) / (std::max)(p.x(), 1e-300));
    if(!(aa + bb > 0) || !std::isfinite(q.y())) {
      p = Eigen::Vector2d(1, 0);
      q = Eigen::Vector2d(0.5, std::sqrt(0.75));
    }
    area = p.x() * q.y() / 2;
    if(!(area >= least_area)) {
      const double factor = std::sqrt(least_area / area);
      p *= factor;
      q *= factor;
      area = least_area;
    }
    gradient[1] = Eigen::Vector2d(q.y(), -q.x()) / (2 * area);
    gradient[2] = Eigen::Vector2d(0, p.x()) / (2 * area);
    gradient[0] = -gradient[1] - gradient[2];
  }

  // Of the map to a triangle in the plane
  Eigen::Matrix2d differential(const Planar_triangle& x) const
  {
    Eigen::Matrix2d result = Eigen::Matrix2d::Zero();
    for(int k = 0; k < 3; ++k)
      result += x[k] * gradient[k].transpose();
    return result;
  }
};

// Rotations u and v, and singular values s, of a matrix of positive determinant
struct Singular_values
{
  Eigen::Vector2d s;
  Eigen::Matrix2d u, v;

  explicit Singular_values(const Eigen::Matrix2d& j)
  {
    const double sum = Eigen::Vector2d(j(0, 0) + j(1, 1), j(1, 0) - j(0, 1)).norm();
    const double difference = Eigen::Vector2d(j(0, 0) - j(1, 1), j(1, 0) + j(0, 1)).norm();
    s[0] = (sum + difference) / 2;
    // not by the difference, which cancels
    s[1] = (j(0, 0) * j(1, 1) - j(0, 1) * j(1, 0)) / s[0];
    const double a = std::atan2(j(1, 0) - j(0, 1), j(0, 0) + j(1, 1));
    const double b = difference > 0 ? std::atan2(j(1, 0) + j(0, 1), j(0, 0) - j(1, 1)) : 0;
    u = Eigen::Rotation2Dd((a + b) / 2).toRotationMatrix();
    v = Eigen::Rotation2Dd((b - a) / 2).toRotationMatrix();
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_TRIANGLE_DIFFERENTIAL_H
