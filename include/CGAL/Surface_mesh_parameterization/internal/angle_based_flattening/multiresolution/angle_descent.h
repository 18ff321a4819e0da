// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sweeps that lower the energy of angles (Eq. 1) of a valid map by moving its vertices, and stretches of the whole map
// in between. `coarse_to_fine.h` and `flatten_injectively.h` end with it, since the relaxation of Section 5.2
// minimizes another energy.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_ANGLE_DESCENT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_ANGLE_DESCENT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_energies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Lowers the energy of the direct method, as a function of the positions of the vertices of a valid map.
class Angle_descent
{
public:
  Angle_descent(const Chart& chart, double barrier, std::vector<Planar_point>& uv)
      : m_chart(chart), m_energy{barrier}, m_beta(target_angles(chart)), m_uv(uv)
  {}

  double energy() const { return m_model.value; }
  Angle_star star() const { return Angle_star(m_beta, m_energy); }

  // Stretches the whole map and relaxes each vertex, in turn, until the energy falls by less than the fraction
  // `tolerance` of it. Returns the number of sweeps over the vertices, which is at most `sweeps`.
  template <typename Relaxation>
  int run(Relaxation& relaxation, int sweeps, double tolerance)
  {
    m_model = model(m_uv);
    int done = 0;
    for(double fall = 1; done < sweeps && fall >= tolerance; ++done) {
      const double before = m_model.value;
      stretch();
      relaxation.sweep(star());
      m_model = model(m_uv);
      fall = before > 0 ? 1 - m_model.value / before : 0;
    }
    return done;
  }

private:
  // The energy as a quadratic function (of Gauss and Newton) of a stretch of the whole map by I + (p, q; q, -p)
  struct Model : Energy_derivatives<2>
  {
    bool is_valid = true;

    Model& operator+=(const Model& other)
    {
      value += other.value;
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
    if(there.is_valid && there.value < m_model.value)
      m_uv = std::move(stretched);
  }

  Model model(const std::vector<Planar_point>& uv) const
  {
    return parallel_sum<Model>(m_chart.number_of_triangles(), [&](int t) { return model(uv, t); });
  }

  Model model(const std::vector<Planar_point>& uv, int t) const
  {
    std::array<Planar_point, 3> edge, turn; // edge k is opposite to corner k
    double longest = 0;
    for(int k = 0; k < 3; ++k) {
      edge[k] = uv[m_chart.vertex[3 * t + (k + 2) % 3]] - uv[m_chart.vertex[3 * t + (k + 1) % 3]];
      const double square = edge[k].squaredNorm();
      longest = (std::max)(longest, square);
      // (p, q) turns the edge by -p sin 2a + q cos 2a, where a is its direction.
      turn[k] = Planar_point(-2 * edge[k].x() * edge[k].y(),
                             edge[k].x() * edge[k].x() - edge[k].y() * edge[k].y()) /
                square;
    }
    const double twice_area = cross(edge[0], edge[1]);
    const double weight = m_chart.weight_of_triangle(t);
    Model result;
    result.is_valid = twice_area > 1e-12 * longest;
    if(!(twice_area > 0))
      return result;
    const std::array<double, 3> alpha =
        planar_angles(twice_area, {-edge[1].dot(edge[2]), -edge[2].dot(edge[0]), -edge[0].dot(edge[1])});
    const std::array<double, 3> beta = {m_beta[3 * t], m_beta[3 * t + 1], m_beta[3 * t + 2]};
    result.value = weight * m_energy.value(alpha, beta);
    for(int k = 0; k < 3; ++k)
      result.add_angle(m_energy, weight, alpha[k], beta[k], turn[(k + 1) % 3] - turn[(k + 2) % 3]);
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
