// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energies of `triangle_energies.h` around one vertex, as functions of its position: MIPS, areas, and angles (Eq.
// 1). The move of the vertex that lowers one of them is the relaxation of Section 5.2, usually with MIPS.
// `relaxation.h` and `border_barrier.h` call it. The paper smooths harmonically instead, which lets stretch grow.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAX_VERTEX_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAX_VERTEX_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_energies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The energy of a star as a function of the position of its vertex. It is infinite where the star is not valid.
template <typename Star>
struct Star_energy : Energy_derivatives<2>
{
  Star_energy(const Star& star, const Planar_point& x, bool with_derivatives)
  {
    for(const typename Star::Triangle& t : star.triangles) {
      const double twice_area = cross(t.p - x, t.q - x);
      if(!(twice_area > star.least_area)) {
        value = (std::numeric_limits<double>::infinity)();
        return;
      }
      star.add(t, x, twice_area, with_derivatives, *this);
    }
  }
};

// The triangles around one vertex, in the plane and in space. They tell where to move the vertex so that both are as
// similar as possible: by MIPS, weighted by area.
struct MIPS_star : Planar_star_base
{
  // A triangle (v, p, q), counterclockwise, with the dot products of the edges at its corners on the surface
  struct Triangle
  {
    Planar_point p, q;
    double dot_v, dot_p, dot_q;
  };

  typedef Star_energy<MIPS_star> Energy;

  std::vector<Triangle> triangles; // clockwise

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    triangles.clear();
    gather_surface_ring(mesh, uv, v, [&](int c, int p, int q, const Surface_edges& e) {
      const double weight = mesh.chart().weight_of_triangle(c / 3);
      triangles.push_back({uv[p], uv[q], weight * e.dot_v(), weight * e.dot_p(), weight * e.dot_q()});
    });
  }

  void add(const Triangle& t, const Planar_point& x, double twice_area, bool with_derivatives,
           Energy_derivatives<2>& sum) const
  {
    add_similarity_at_corner(t, x, twice_area, with_derivatives, sum);
  }

  // What a barrier at the vertex is multiplied by: the mean energy of an undistorted triangle. (The products of two
  // cotangents in a triangle add up to 1.)
  double barrier_weight() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += 2 * std::sqrt((std::max)(t.dot_v * t.dot_p + t.dot_p * t.dot_q + t.dot_q * t.dot_v, 0.));
    return sum / static_cast<double>(triangles.size());
  }
};

// The same with areas: they tell where to move the vertex to lower `area_energy()`. Its energy is four times that.
struct Area_star : Planar_star_base
{
  struct Triangle : MIPS_star::Triangle
  {
    double weight;       // of its energy
    double inverse_area; // of twice its area on the surface
  };

  typedef Star_energy<Area_star> Energy;

  double theta;
  std::vector<Triangle> triangles; // clockwise

  explicit Area_star(double area_weight) : theta(area_weight) {}

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    triangles.clear();
    gather_surface_ring(mesh, uv, v, [&](int c, int p, int q, const Surface_edges& e) {
      const double twice_area = (std::max)(e.twice_area(), 1e-6 * e.sum_of_squares() + 1e-300);
      triangles.push_back({{uv[p], uv[q], e.dot_v(), e.dot_p(), e.dot_q()},
                           mesh.chart().weight_of_triangle(c / 3),
                           1 / twice_area});
    });
  }

  void add(const Triangle& t, const Planar_point& x, double twice_area, bool with_derivatives,
           Energy_derivatives<2>& sum) const
  {
    add_area_energy_at_corner(theta, t, x, twice_area, with_derivatives, sum);
  }

  double barrier_weight() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += 2 * t.weight / t.inverse_area;
    return sum / static_cast<double>(triangles.size());
  }
};

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

  typedef Star_energy<Angle_star> Energy;

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
      triangles.push_back({uv[p], uv[q], targets(c), mesh.chart().weight_of_triangle(c / 3)});
    });
  }

  void add(const Triangle& t, const Planar_point& x, double, bool with_derivatives,
           Energy_derivatives<2>& sum) const
  {
    add_angles_at_corner(energy, t.weight, t.beta, {x, t.p, t.q}, with_derivatives, sum);
  }

  double barrier_weight() const
  {
    double sum = 0;
    for(const Triangle& t : triangles)
      sum += t.weight;
    return 0.01 * sum / static_cast<double>(triangles.size());
  }

protected:
  std::array<double, 3> targets(int c) const
  {
    return {beta[c], beta[next_corner(c)], beta[previous_corner(c)]};
  }
};

// With the weight of MIPS, the area on the surface: a level has triangles of very different sizes, and the smallest
// ones would count most.
struct Area_angle_star : Angle_star
{
  using Angle_star::Angle_star;

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    triangles.clear();
    gather_surface_ring(mesh, uv, v, [&](int c, int p, int q, const Surface_edges& e) {
      const double weight = mesh.chart().weight_of_triangle(c / 3) * e.twice_area();
      triangles.push_back({uv[p], uv[q], targets(c), weight});
    });
  }
};

// A step of Newton's method towards the least energy of a star, or along the gradient where the energy is not convex
inline Planar_point newton_step(const Energy_derivatives<2>& here)
{
  const double determinant =
      here.hessian(0, 0) * here.hessian(1, 1) - here.hessian(0, 1) * here.hessian(0, 1);
  if(!(determinant > 0 && here.hessian.trace() > 0))
    return -here.gradient / (here.hessian.cwiseAbs().sum() + (std::numeric_limits<double>::min)());
  return Planar_point(here.hessian(0, 1) * here.gradient.y() - here.hessian(1, 1) * here.gradient.x(),
                      here.hessian(0, 1) * here.gradient.x() - here.hessian(0, 0) * here.gradient.y()) /
         determinant;
}

// Moves a vertex by an over-relaxed Newton step, where `accept` allows it. Returns by which factor the energy
// of its star fell, or 1 if the vertex does not move.
template <typename Star, typename Accept>
double relax_vertex(const Star& star, Planar_point& position, const Accept& accept)
{
  typedef typename Star::Energy Energy;
  const Energy here(star, position, true);
  if(!std::isfinite(here.value))
    return 1;
  Planar_point step = star.over_relaxation * newton_step(here);
  for(int halvings = 0; halvings < 5; ++halvings, step /= 2) {
    const Planar_point next = position + step;
    const double value = Energy(star, next, false).value;
    if(value < here.value && accept(next)) {
      position = next;
      return value / here.value;
    }
  }
  return 1;
}

// The same by several steps where triangles are nearly degenerate: each step makes such a triangle higher by a third
// only.
template <typename Star, typename Accept>
double relax_vertex_repeatedly(const Star& star, Planar_point& position, const Accept& accept)
{
  const int most_steps = 50;
  double fall = relax_vertex(star, position, accept), whole = fall;
  for(int step = 1; step < most_steps && fall < 0.7; ++step)
    whole *= fall = relax_vertex(star, position, accept);
  return whole;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAX_VERTEX_H
