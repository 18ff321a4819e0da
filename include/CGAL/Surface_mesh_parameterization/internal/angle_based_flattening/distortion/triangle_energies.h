// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energies of one triangle in the plane: that of its angles (Eq. 1), MIPS (Hormann and Greiner 2000), and MIPS
// times a power of an area term, which includes the symmetric Dirichlet energy. Each has a value, a gradient and a
// Hessian, by the position of one corner for `relax_vertex.h`, or of all three for `objectives.h`. A new energy belongs
// here.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_TRIANGLE_ENERGIES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_TRIANGLE_ENERGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_differential.h>

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// An energy, or a sum of energies, with its derivatives by N parameters
template <int N>
struct Energy_derivatives
{
  typedef Eigen::Matrix<double, N, 1> Gradient;
  typedef Eigen::Matrix<double, N, N> Hessian;

  double value = 0;
  Gradient gradient = Gradient::Zero();
  Hessian hessian = Hessian::Zero();

  // Adds the derivatives of the energy of an angle alpha, which changes by `slope` as the parameters do. The Hessian is
  // that of Gauss and Newton, which is never indefinite.
  void add_angle(const Angle_energy& energy, double weight, double alpha, double beta, const Gradient& slope)
  {
    gradient += weight * energy.first_derivative(alpha, beta) * slope;
    hessian += weight * energy.second_derivative(alpha, beta) * slope * slope.transpose();
  }
};

// An energy by the positions of the three corners of a triangle. The Hessian has no negative eigenvalues.
typedef Energy_derivatives<6> Triangle_derivatives;

// How the direction of an edge in the plane changes as its end moves
inline Planar_point turn_of_edge(const Planar_point& edge)
{
  return Planar_point(-edge.y(), edge.x()) / edge.squaredNorm();
}

// The energy of the angles of a triangle (Eq. 1) times `weight`
inline Triangle_derivatives angle_derivatives(const Angle_energy& energy, double weight,
                                              const std::array<double, 3>& beta, const Planar_triangle& x)
{
  const std::array<double, 3> alpha = planar_angles(x);
  std::array<Planar_point, 3> turn; // of the edge from corner k + 1 to k + 2
  for(int k = 0; k < 3; ++k)
    turn[k] = turn_of_edge(x[(k + 2) % 3] - x[(k + 1) % 3]);
  Triangle_derivatives result;
  result.value = weight * energy.value(alpha, beta);
  for(int k = 0; k < 3; ++k) {
    const int p = (k + 1) % 3, q = (k + 2) % 3;
    Triangle_derivatives::Gradient slope;
    slope.segment<2>(2 * q) = -turn[p];
    slope.segment<2>(2 * p) = -turn[q];
    slope.segment<2>(2 * k) = turn[p] + turn[q];
    result.add_angle(energy, weight, alpha[k], beta[k], slope);
  }
  return result;
}

// Adds the energy of the angles of a triangle to a sum, with derivatives on demand, as a function of its first corner.
inline void add_angles_at_corner(const Angle_energy& energy, double weight, const std::array<double, 3>& beta,
                                 const Planar_triangle& x, bool with_derivatives, Energy_derivatives<2>& sum)
{
  const std::array<double, 3> alpha = planar_angles(x);
  sum.value += weight * energy.value(alpha, beta);
  if(!with_derivatives)
    return;
  // The angle at p changes if x moves across the edge to p, but not if it moves along the edge.
  const Planar_point along_p = turn_of_edge(x[0] - x[1]), along_q = turn_of_edge(x[2] - x[0]);
  sum.add_angle(energy, weight, alpha[1], beta[1], along_p);
  sum.add_angle(energy, weight, alpha[2], beta[2], along_q);
  sum.add_angle(energy, weight, alpha[0], beta[0], -along_p - along_q);
}

// Four times MIPS of a triangle (x, p, q) times its area on the surface, as a function of x: the ratio of Dirichlet
// energy to planar area. It is least for a similar triangle, and grows without bound as the triangle collapses.
//
// `Triangle` has the positions p and q, and the dot products of the edges at its corners on the surface. These are
// twice the area times the cotangents of the angles: neither roots nor divisions are needed.
template <typename Triangle>
class Similarity_energy
{
public:
  double value, inverse; // of twice the area in the plane

  Similarity_energy(const Triangle& triangle, const Planar_point& x, double twice_area)
      : inverse(1 / twice_area), m_triangle(triangle), m_xp(x - triangle.p), m_xq(x - triangle.q),
        m_pq(triangle.q - triangle.p)
  {
    value = (triangle.dot_q * m_xp.squaredNorm() + triangle.dot_p * m_xq.squaredNorm() +
             triangle.dot_v * m_pq.squaredNorm()) *
            inverse;
  }

  // Of twice the area in the plane
  Planar_point area_gradient() const { return Planar_point(-m_pq.y(), m_pq.x()); }

  Planar_point dirichlet_gradient() const { return 2 * (m_triangle.dot_q * m_xp + m_triangle.dot_p * m_xq); }

  Planar_point gradient() const { return (dirichlet_gradient() - value * area_gradient()) * inverse; }

  Eigen::Matrix2d hessian(const Planar_point& gradient) const
  {
    const Planar_point mixed = (2 * inverse) * area_gradient();
    const double squared_edge = 2 * inverse * (m_triangle.dot_p + m_triangle.dot_q);
    const double off_diagonal = -(gradient.x() * mixed.y() + gradient.y() * mixed.x()) / 2;
    Eigen::Matrix2d result;
    result << squared_edge - gradient.x() * mixed.x(), off_diagonal, off_diagonal,
        squared_edge - gradient.y() * mixed.y();
    return result;
  }

private:
  const Triangle& m_triangle;
  Planar_point m_xp, m_xq, m_pq;
};

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

// Adds `Similarity_energy` to a sum, with derivatives on demand.
template <typename Triangle>
void add_similarity_at_corner(const Triangle& triangle, const Planar_point& x, double twice_area,
                              bool with_derivatives, Energy_derivatives<2>& sum)
{
  const Similarity_energy<Triangle> mips(triangle, x, twice_area);
  sum.value += mips.value;
  if(!with_derivatives)
    return;
  const Planar_point gradient = mips.gradient();
  sum.gradient += gradient;
  sum.hessian += mips.hessian(gradient);
}

// Adds the same times a weight, and times the power theta of the area term: four times `area_energy()`. `Triangle` also
// has this weight, and the inverse of twice its area on the surface.
template <typename Triangle>
void add_area_energy_at_corner(double theta, const Triangle& triangle, const Planar_point& x,
                               double twice_area, bool with_derivatives, Energy_derivatives<2>& sum)
{
  const Similarity_energy<Triangle> mips(triangle, x, twice_area);
  const Area_term area(twice_area * triangle.inverse_area);
  const double factor = triangle.weight * std::exp(theta * area.value);
  sum.value += factor * mips.value;
  if(!with_derivatives)
    return;
  const Planar_point area_gradient = mips.area_gradient() * mips.inverse; // of its logarithm
  const Planar_point gradient = mips.inverse * mips.dirichlet_gradient() - mips.value * area_gradient;
  const double slope = theta * area.first_derivative;
  sum.gradient += factor * (gradient + mips.value * slope * area_gradient);
  const Eigen::Matrix2d mixed = gradient * area_gradient.transpose();
  const double curvature = mips.value * (theta * area.second_derivative + slope * slope - slope);
  sum.hessian += factor * ((slope - 1) * (mixed + mixed.transpose()) +
                           curvature * area_gradient * area_gradient.transpose());
  sum.hessian.diagonal().array() += factor * 2 * mips.inverse * (triangle.dot_p + triangle.dot_q);
}

// A triangle's share in the energy that injective maps minimize: its area on the surface times
//
//   MIPS * ((d + 1/d) / 2)^theta,  MIPS = (s1 / s2 + s2 / s1) / 2,  d = s1 s2,
//
// where s1 >= s2 are the singular values of the differential. At theta = 1 this is a quarter of the symmetric Dirichlet
// energy.
inline double area_energy(double theta, const Flat_triangle& triangle, const Planar_triangle& x)
{
  const Eigen::Matrix2d differential = triangle.differential(x);
  const double d = differential.determinant();
  return triangle.area * differential.squaredNorm() / (2 * d) * std::exp(theta * Area_term(d).value);
}

// `area_energy()` times `weight`. The eigenvectors of its Hessian are known: two mix the singular values, one turns,
// and one shears. Those of negative eigenvalues are left out.
inline Triangle_derivatives area_derivatives(double theta, double weight, const Flat_triangle& triangle,
                                             const Planar_triangle& x)
{
  const Singular_values svd(triangle.differential(x));
  const Eigen::Vector2d& s = svd.s;
  const double product = s[0] * s[1], q = s[0] * s[0] + s[1] * s[1];
  const Area_term area(product);
  const double density = (s[0] / s[1] + s[1] / s[0]) / 2 * std::exp(theta * area.value);
  // of its logarithm, by the singular values
  const double h = theta * area.first_derivative - 1;
  const Eigen::Vector2d slope(2 * s[0] / q + h / s[0], 2 * s[1] / q + h / s[1]);

  Triangle_derivatives result;
  result.value = weight * (triangle.area * density);
  const Eigen::Matrix2d stress = svd.u * (density * slope).asDiagonal() * svd.v.transpose();
  for(int k = 0; k < 3; ++k)
    result.gradient.segment<2>(2 * k) = triangle.area * stress * triangle.gradient[k];

  const auto add = [&](double eigenvalue, const Eigen::Matrix2d& m) { // with the eigenvector u m v'
    if(!(eigenvalue > 0))
      return;
    const Eigen::Matrix2d direction = svd.u * m * svd.v.transpose();
    Triangle_derivatives::Gradient g;
    for(int k = 0; k < 3; ++k)
      g.segment<2>(2 * k) = direction * triangle.gradient[k];
    result.hessian += triangle.area * eigenvalue * g * g.transpose();
  };
  Eigen::Matrix2d block = slope * slope.transpose() - 4 / (q * q) * s * s.transpose();
  for(int i = 0; i < 2; ++i)
    block(i, i) += 2 / q + -h / (s[i] * s[i]) + theta * area.second_derivative / (s[i] * s[i]);
  block(0, 1) += theta * area.second_derivative / product;
  block(1, 0) = block(0, 1);
  block *= density;
  const double mean = (block(0, 0) + block(1, 1)) / 2, half = (block(0, 0) - block(1, 1)) / 2;
  const double radius = Eigen::Vector2d(half, block(0, 1)).norm();
  const double angle = std::atan2(block(0, 1), half) / 2;
  for(int k = 0; k < 2; ++k) {
    const double phi = angle + k * pi / 2;
    add(k == 0 ? mean + radius : mean - radius, Eigen::Vector2d(std::cos(phi), std::sin(phi)).asDiagonal());
  }
  const double bend = -h / product, root = std::sqrt(0.5);
  add(density * (2 / q - bend), (Eigen::Matrix2d() << 0, -root, root, 0).finished());
  add(density * (2 / q + bend), (Eigen::Matrix2d() << 0, root, root, 0).finished());
  result.gradient *= weight;
  result.hessian *= weight;
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_DISTORTION_TRIANGLE_ENERGIES_H
