// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sweeps that lower the energy of angles (Eq. 1) of a valid map by moving its vertices, and stretches of the whole map
// in between. `coarse_to_fine.h` and `flatten_injectively.h` end with it, since the relaxation of Section 5.2
// minimizes another energy.
//
// The energy of angles (Eq. 1) around one vertex as a function of its position, with gradient and Gauss-Newton Hessian.
// `angle_descent.h` moves one vertex after the other by it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_ANGLE_DESCENT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_ANGLE_DESCENT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The triangles around one vertex in the plane, with the target angles of all their corners. They tell where to move
// the vertex to minimize the energy of the direct method.
struct Angle_star : Planar_star_base
{
  struct Triangle
  {
    Planar_point p, q;
    std::array<double, 3> beta; // of the corners at v, p, q
    double weight;
  };

  class Energy;

  std::vector<Triangle> triangles; // clockwise
  const std::vector<double>& beta; // target angle of each corner
  Angle_energy energy;

  Angle_star(const std::vector<double>& target_angles, const Angle_energy& angle_energy)
      : beta(target_angles), energy(angle_energy)
  {}

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    triangles.clear();
    gather_ring(mesh, uv, v, [&](int c, int p, int q) {
      triangles.push_back({uv[p],
                           uv[q],
                           {beta[c], beta[next_corner(c)], beta[previous_corner(c)]},
                           mesh.chart().weight_of_triangle(c / 3)});
    });
  }

  // What the barrier between parts of the border is multiplied by
  double barrier_weight() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += t.weight;
    return 0.01 * sum / static_cast<double>(triangles.size());
  }
};

// The energy of the angles of a star as a function of the position of its vertex. The Hessian is that of
// Gauss-Newton, which is never indefinite. The energy is infinite where the star is not valid.
class Angle_star::Energy
{
public:
  double value = 0;
  Planar_point gradient = Planar_point::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();

  Energy(const Angle_star& star, const Planar_point& x, bool with_derivatives)
  {
    for(const Triangle& t : star.triangles) {
      const Planar_point to_p = t.p - x, to_q = t.q - x, pq = t.q - t.p;
      const double twice_area = cross(to_p, to_q);
      if(!(twice_area > star.least_area)) {
        value = (std::numeric_limits<double>::infinity)();
        return;
      }
      const std::array<double, 3> alpha =
          planar_angles(twice_area, {to_p.dot(to_q), -to_p.dot(pq), to_q.dot(pq)});
      value += t.weight * star.energy.value(alpha, t.beta);
      if(!with_derivatives)
        continue;
      // The angle at p changes if x moves across the edge to p, but not if it moves along the edge.
      const Planar_point along_p = Planar_point(to_p.y(), -to_p.x()) / to_p.squaredNorm();
      const Planar_point along_q = Planar_point(-to_q.y(), to_q.x()) / to_q.squaredNorm();
      add(star.energy, t.weight, alpha[1], t.beta[1], along_p);
      add(star.energy, t.weight, alpha[2], t.beta[2], along_q);
      add(star.energy, t.weight, alpha[0], t.beta[0], -along_p - along_q);
    }
  }

private:
  void add(const Angle_energy& energy, double weight, double alpha, double beta,
           const Planar_point& angle_gradient)
  {
    gradient += weight * energy.first_derivative(alpha, beta) * angle_gradient;
    hessian += weight * energy.second_derivative(alpha, beta) * angle_gradient * angle_gradient.transpose();
  }
};

// Lowers the energy of the direct method, as a function of the positions of the vertices of a valid map.
class Angle_descent
{
public:
  Angle_descent(const Chart& chart, double barrier, std::vector<Planar_point>& uv)
      : m_chart(chart), m_energy{barrier}, m_beta(target_angles(chart)), m_uv(uv)
  {}

  double energy() const { return m_model.energy; }
  Angle_star star() const { return Angle_star(m_beta, m_energy); }

  // Stretches the whole map and relaxes each vertex, in turn, until the energy falls by less than the fraction
  // `tolerance` of it. Returns the number of sweeps over the vertices, which is at most `sweeps`.
  template <typename Relaxation>
  int run(Relaxation& relaxation, int sweeps, double tolerance)
  {
    m_model = model(m_uv);
    int done = 0;
    for(double fall = 1; done < sweeps && fall >= tolerance; ++done) {
      const double before = m_model.energy;
      stretch();
      relaxation.sweep(star());
      m_model = model(m_uv);
      fall = before > 0 ? 1 - m_model.energy / before : 0;
    }
    return done;
  }

private:
  // The energy as a quadratic function (of Gauss and Newton) of a stretch of the whole map by I + (p, q; q, -p)
  struct Model
  {
    double energy = 0;
    bool is_valid = true;
    Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
    Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();

    Model& operator+=(const Model& other)
    {
      energy += other.energy;
      is_valid = is_valid && other.is_valid;
      gradient += other.gradient;
      hessian += other.hessian;
      return *this;
    }
  };

  // Noise on a regular grid acts like a stretch in one direction. A coarse chart does not have this noise, and moving
  // one vertex after the other takes forever to stretch the whole map.
  void stretch()
  {
    if(!(m_model.hessian.determinant() > 0))
      return;
    Eigen::Vector2d step = -m_model.hessian.inverse() * m_model.gradient;
    step /= (std::max)(1., 2 * step.norm()); // the map stays positively oriented for lengths below 1
    Eigen::Matrix2d matrix;
    matrix << 1 + step.x(), step.y(), step.y(), 1 - step.x();
    std::vector<Planar_point> stretched(m_uv.size());
    for(std::size_t v = 0; v < m_uv.size(); ++v)
      stretched[v] = matrix * m_uv[v];
    const Model there = model(stretched);
    if(there.is_valid && there.energy < m_model.energy)
      m_uv = std::move(stretched);
  }

  Model model(const std::vector<Planar_point>& uv) const
  {
    return parallel_sum<Model>(m_chart.number_of_triangles(), [&](int t) { return model(uv, t); });
  }

  Model model(const std::vector<Planar_point>& uv, int t) const
  {
    std::array<Planar_point, 3> edge, turn; // edge k is opposite to corner k
    for(int k = 0; k < 3; ++k) {
      edge[k] = uv[m_chart.vertex[3 * t + (k + 2) % 3]] - uv[m_chart.vertex[3 * t + (k + 1) % 3]];
      // How (p, q) turns the edge: by -p sin 2a + q cos 2a, where a is its direction
      turn[k] = Planar_point(-2 * edge[k].x() * edge[k].y(),
                             edge[k].x() * edge[k].x() - edge[k].y() * edge[k].y()) /
                edge[k].squaredNorm();
    }
    const double twice_area = cross(edge[0], edge[1]);
    const double weight = m_chart.weight_of_triangle(t);
    Model result;
    result.is_valid = twice_area > 1e-12 * (std::max)({edge[0].squaredNorm(), edge[1].squaredNorm(),
                                                       edge[2].squaredNorm()});
    if(!(twice_area > 0))
      return result;
    const std::array<double, 3> alpha =
        planar_angles(twice_area, {-edge[1].dot(edge[2]), -edge[2].dot(edge[0]), -edge[0].dot(edge[1])});
    const std::array<double, 3> beta = {m_beta[3 * t], m_beta[3 * t + 1], m_beta[3 * t + 2]};
    result.energy = weight * m_energy.value(alpha, beta);
    for(int k = 0; k < 3; ++k) {
      const Eigen::Vector2d row = turn[(k + 1) % 3] - turn[(k + 2) % 3];
      result.gradient += weight * m_energy.first_derivative(alpha[k], beta[k]) * row;
      result.hessian += weight * m_energy.second_derivative(alpha[k], beta[k]) * row * row.transpose();
    }
    return result;
  }

  const Chart& m_chart;
  Angle_energy m_energy;
  std::vector<double> m_beta;
  std::vector<Planar_point>& m_uv;
  Model m_model; // at the present positions, once `run()` has begun
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_ANGLE_DESCENT_H
