// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of one triangle in an injective map: MIPS (Hormann and Greiner 2000) times a power of an area term, with
// derivatives. It grows without bound as a triangle collapses, so descents never turn one over. `area_objective.h` sums
// it over a map, `area_star.h` over the triangles around a vertex.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_ENERGY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_ENERGY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The logarithm of (d + 1/d) / 2, where d is the ratio of the areas in the plane and on the surface, and its first two
// derivatives by the logarithm of d. It is least, 0, where the area is kept.
struct Area_term
{
  double value, first_derivative, second_derivative;

  explicit Area_term(double d)
  {
    const double square = d * d, sum = square + 1;
    value = std::log(sum / (2 * d));
    first_derivative = (square - 1) / sum;
    second_derivative = 4 * square / (sum * sum);
  }
};

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
};

// A triangle's share in the energy that injective maps minimize: its area on the surface times
//
//   MIPS * ((d + 1/d) / 2)^theta,  MIPS = (s1 / s2 + s2 / s1) / 2,  d = s1 s2,
//
// where s1 >= s2 are the singular values of the differential. At theta = 1 this is a quarter of the symmetric Dirichlet
// energy.
class Area_energy
{
public:
  typedef Eigen::Matrix<double, 6, 1> Gradient;
  typedef Eigen::Matrix<double, 6, 6> Hessian;

  Area_energy(const Flat_triangle& triangle, const std::array<Planar_point, 3>& x, double theta)
      : m_triangle(triangle), m_theta(theta)
  {
    Eigen::Matrix2d differential = Eigen::Matrix2d::Zero();
    for(int k = 0; k < 3; ++k)
      differential += x[k] * triangle.gradient[k].transpose();
    decompose(differential);
    const Area_term area(m_s1 * m_s2);
    m_first = area.first_derivative;
    m_second = area.second_derivative;
    m_density = (m_s1 / m_s2 + m_s2 / m_s1) / 2 * std::exp(theta * area.value);
  }

  double value() const { return m_triangle.area * m_density; }

  // The same, without what only derivatives need
  static double value(const Flat_triangle& triangle, const std::array<Planar_point, 3>& x, double theta)
  {
    Eigen::Matrix2d differential = Eigen::Matrix2d::Zero();
    for(int k = 0; k < 3; ++k)
      differential += x[k] * triangle.gradient[k].transpose();
    const double d = differential.determinant();
    return triangle.area * differential.squaredNorm() / (2 * d) * std::exp(theta * Area_term(d).value);
  }

  // By the coordinates of the three corners
  Gradient gradient() const
  {
    const Eigen::Vector2d slope = slopes();
    Gradient result;
    const Eigen::Matrix2d stress = m_u * slope.asDiagonal() * m_v.transpose();
    for(int k = 0; k < 3; ++k)
      result.segment<2>(2 * k) = m_triangle.area * stress * m_triangle.gradient[k];
    return result;
  }

  // The Hessian without its negative eigenvalues. Its eigenvectors are known: two mix the singular values, one turns,
  // and one shears.
  Hessian projected_hessian() const
  {
    const double q = m_s1 * m_s1 + m_s2 * m_s2, product = m_s1 * m_s2;
    const double bend = (1 - m_theta * m_first) / product;
    const double turning = m_density * (2 / q - bend), shearing = m_density * (2 / q + bend);
    Hessian hessian = Hessian::Zero();
    add_stretching(hessian);
    Eigen::Matrix2d turn, shear;
    turn << 0, -std::sqrt(0.5), std::sqrt(0.5), 0;
    shear << 0, std::sqrt(0.5), std::sqrt(0.5), 0;
    add(hessian, turning, turn);
    add(hessian, shearing, shear);
    return hessian;
  }

private:
  // Rotations u and v, and singular values, of a matrix of positive determinant
  void decompose(const Eigen::Matrix2d& j)
  {
    const double sum = Eigen::Vector2d(j(0, 0) + j(1, 1), j(1, 0) - j(0, 1)).norm();
    const double difference = Eigen::Vector2d(j(0, 0) - j(1, 1), j(1, 0) + j(0, 1)).norm();
    m_s1 = (sum + difference) / 2;
    // not by the difference, which cancels
    m_s2 = (j(0, 0) * j(1, 1) - j(0, 1) * j(1, 0)) / m_s1;
    const double a = std::atan2(j(1, 0) - j(0, 1), j(0, 0) + j(1, 1));
    const double b = difference > 0 ? std::atan2(j(1, 0) + j(0, 1), j(0, 0) - j(1, 1)) : 0;
    m_u = Eigen::Rotation2Dd((a + b) / 2).toRotationMatrix();
    m_v = Eigen::Rotation2Dd((b - a) / 2).toRotationMatrix();
  }

  // The derivatives of the density by the singular values
  Eigen::Vector2d slopes() const { return m_density * logarithmic_slopes(); }

  Eigen::Vector2d logarithmic_slopes() const
  {
    const double q = m_s1 * m_s1 + m_s2 * m_s2, h = m_theta * m_first - 1;
    return Eigen::Vector2d(2 * m_s1 / q + h / m_s1, 2 * m_s2 / q + h / m_s2);
  }

  void add_stretching(Hessian& hessian) const
  {
    const double q = m_s1 * m_s1 + m_s2 * m_s2, product = m_s1 * m_s2;
    const Eigen::Vector2d s(m_s1, m_s2), slope = logarithmic_slopes();
    Eigen::Matrix2d block = slope * slope.transpose() - 4 / (q * q) * s * s.transpose();
    for(int i = 0; i < 2; ++i)
      block(i, i) += 2 / q + (1 - m_theta * m_first) / (s[i] * s[i]) + m_theta * m_second / (s[i] * s[i]);
    block(0, 1) += m_theta * m_second / product;
    block(1, 0) = block(0, 1);
    block *= m_density;
    const double mean = (block(0, 0) + block(1, 1)) / 2, half = (block(0, 0) - block(1, 1)) / 2;
    const double radius = Eigen::Vector2d(half, block(0, 1)).norm();
    const double angle = std::atan2(block(0, 1), half) / 2;
    for(int k = 0; k < 2; ++k) {
      const double phi = angle + k * pi / 2;
      add(hessian, k == 0 ? mean + radius : mean - radius,
          Eigen::Vector2d(std::cos(phi), std::sin(phi)).asDiagonal());
    }
  }

  // Adds the eigenvector u m v' unless its eigenvalue is negative.
  void add(Hessian& hessian, double eigenvalue, const Eigen::Matrix2d& m) const
  {
    if(!(eigenvalue > 0))
      return;
    const Eigen::Matrix2d direction = m_u * m * m_v.transpose();
    Gradient g;
    for(int k = 0; k < 3; ++k)
      g.segment<2>(2 * k) = direction * m_triangle.gradient[k];
    hessian += m_triangle.area * eigenvalue * g * g.transpose();
  }

  const Flat_triangle& m_triangle;
  double m_theta;
  Eigen::Matrix2d m_u, m_v;
  double m_s1, m_s2;
  double m_density, m_first, m_second;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_AREA_ENERGY_H
