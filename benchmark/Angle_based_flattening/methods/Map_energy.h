// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_MAP_ENERGY_H
#define ABF_BENCHMARK_MAP_ENERGY_H

#include "chart_method.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/triangle_assembly.h>

#include <Eigen/Eigenvalues>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace ABF_benchmark {

typedef Eigen::Matrix<double, 6, 1> Vector_6;
typedef Eigen::Matrix<double, 6, 6> Matrix_6;

// The energy of a triangle as a function of its Dirichlet energy D and its area A in the plane, with derivatives. It
// is linear in D.
struct Triangle_energy
{
  double value, by_d, by_a, by_d_and_a, by_a_twice;
};

// MIPS (Hormann and Greiner 2000): sigma_1 / sigma_2 + sigma_2 / sigma_1, 2 at best.
struct MIPS_energy
{
  static Triangle_energy at(double d, double a, double)
  {
    return {2 * d / a, 2 / a, -2 * d / (a * a), -2 / (a * a), 4 * d / (a * a * a)};
  }
};

// The squared L2 stretch of Sander et al. (2001), times the area s on the surface, plus the area in the plane. For
// the best scaling of a map, this sum is 2 s times the L2 stretch for equal areas. So stretch and scale are minimized
// together without a constraint.
struct Stretch_energy
{
  static Triangle_energy at(double d, double a, double s)
  {
    const double r = s / a, rr = r * r;
    return {d * rr + a, rr, 1 - 2 * d * rr / a, -2 * rr / a, 6 * d * rr / (a * a)};
  }
};

// A sum of such energies over a chart, of the coordinates of all vertices: u and v of vertex i are numbers 2i and
// 2i + 1. It is infinite where a triangle is not positively oriented.
template <typename Energy>
class Map_energy
{
public:
  explicit Map_energy(const Chart& chart)
      : m_chart(chart), m_all_vertices(boost::counting_iterator<int>(0),
                                       boost::counting_iterator<int>(chart.number_of_vertices())),
        m_local_hessian(chart.number_of_triangles()),
        m_hessian(chart.vertex, m_all_vertices, chart.number_of_vertices())
  {
    m_area_hessian.setZero();
    for(int k = 0; k < 3; ++k) { // A = sum of x_k cross x_{k+1}, halved
      const int next = (k + 1) % 3;
      m_area_hessian(2 * k, 2 * next + 1) = m_area_hessian(2 * next + 1, 2 * k) = 0.5;
      m_area_hessian(2 * k + 1, 2 * next) = m_area_hessian(2 * next, 2 * k + 1) = -0.5;
    }
    for(int t = 0; t < chart.number_of_triangles(); ++t)
      m_surface.push_back(Surface_triangle(chart, t));
  }

  double value(const Eigen::VectorXd& x) const
  {
    double sum = 0;
    for(int t = 0; t < m_chart.number_of_triangles(); ++t) {
      const Vector_6 local = gather(t, x);
      const double area = local.dot(m_area_hessian * local) / 2;
      if(!(area > 0))
        return std::numeric_limits<double>::infinity();
      sum += Energy::at(local.dot(dirichlet_hessian(t) * local) / 2, area, m_surface[t].area).value;
    }
    return sum;
  }

  // The gradient, and a positive semidefinite Hessian: that of each triangle without its negative eigenvalues.
  Eigen::SparseMatrix<double> derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)
  {
    gradient = Eigen::VectorXd::Zero(x.size());
    for(int t = 0; t < m_chart.number_of_triangles(); ++t) {
      const Vector_6 local = gather(t, x);
      const Matrix_6 h_d = dirichlet_hessian(t);
      const Vector_6 d = h_d * local, a = m_area_hessian * local;
      const Triangle_energy e = Energy::at(local.dot(d) / 2, local.dot(a) / 2, m_surface[t].area);
      const Vector_6 local_gradient = e.by_d * d + e.by_a * a;
      for(int k = 0; k < 3; ++k)
        gradient.segment<2>(2 * m_chart.vertex[3 * t + k]) += local_gradient.segment<2>(2 * k);
      const Matrix_6 mixed = d * a.transpose();
      m_local_hessian[t] =
          semidefinite(e.by_d * h_d + e.by_a * m_area_hessian + e.by_d_and_a * (mixed + mixed.transpose()) +
                       e.by_a_twice * a * a.transpose());
    }
    m_hessian.assemble([&](int c) -> typename abf::Triangle_assembly<2>::Local_columns {
      typename abf::Triangle_assembly<2>::Local_columns columns;
      Eigen::Map<Eigen::Matrix<double, 6, 2>>(columns.entry) =
          m_local_hessian[c / 3].template middleCols<2>(2 * (c % 3));
      return columns;
    });
    return abf::eigen_matrix<double>(m_hessian.matrix());
  }

private:
  // Area and cotangents on the surface; those of needles are bounded.
  struct Surface_triangle
  {
    std::array<double, 3> cotangent;
    double area;

    Surface_triangle(const Chart& chart, int t)
    {
      std::array<Chart::Point_3, 3> p;
      for(int k = 0; k < 3; ++k)
        p[k] = chart.points[chart.vertex[3 * t + k]];
      const double longest =
          (std::max)({CGAL::squared_distance(p[0], p[1]), CGAL::squared_distance(p[1], p[2]),
                      CGAL::squared_distance(p[2], p[0])});
      area = (std::max)(abf::surface_area(chart, t), 1e-6 * longest);
      for(int k = 0; k < 3; ++k)
        cotangent[k] = (p[(k + 1) % 3] - p[k]) * (p[(k + 2) % 3] - p[k]) / (2 * area);
    }
  };

  Vector_6 gather(int t, const Eigen::VectorXd& x) const
  {
    Vector_6 local;
    for(int k = 0; k < 3; ++k)
      local.segment<2>(2 * k) = x.segment<2>(2 * m_chart.vertex[3 * t + k]);
    return local;
  }

  // D = sum of cot_k |x_{k+1} - x_{k-1}|^2 / 4, which is the area for a triangle as on the surface.
  Matrix_6 dirichlet_hessian(int t) const
  {
    Matrix_6 h = Matrix_6::Zero();
    for(int k = 0; k < 3; ++k) {
      const double weight = m_surface[t].cotangent[k] / 2;
      const int i = 2 * ((k + 1) % 3), j = 2 * ((k + 2) % 3);
      for(int e : {0, 1}) {
        h(i + e, i + e) += weight;
        h(j + e, j + e) += weight;
        h(i + e, j + e) = h(j + e, i + e) = -weight;
      }
    }
    return h;
  }

  static Matrix_6 semidefinite(const Matrix_6& h)
  {
    const Eigen::SelfAdjointEigenSolver<Matrix_6> eigen(h);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
           eigen.eigenvectors().transpose();
  }

  const Chart& m_chart;
  std::vector<Surface_triangle> m_surface;
  Matrix_6 m_area_hessian;
  std::vector<int> m_all_vertices; // ranks as unknowns
  std::vector<Matrix_6> m_local_hessian;
  abf::Triangle_assembly<2> m_hessian;
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_MAP_ENERGY_H
