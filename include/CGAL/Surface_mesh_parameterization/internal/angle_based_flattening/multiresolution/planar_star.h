// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The triangles around one vertex, on the surface and in the plane, and whether a position of the vertex is valid,
// rounding included. `insert_vertex.h` takes its weights from `Planar_star` (Section 5.2). The stars of
// `relax_vertex.h` share its base.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_PLANAR_STAR_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_PLANAR_STAR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Calls `visit` with the corner at `v` of each triangle, clockwise, and its two other vertices.
template <typename Visitor>
void for_each_ring_triangle(const Edge_collapses& mesh, int v, const Visitor& visit)
{
  const Chart& chart = mesh.chart();
  int q = -1; // each triangle starts where the previous one ended
  mesh.for_each_corner(v, [&](int c) {
    if(q < 0)
      q = chart.vertex[previous_corner(c)];
    const int p = chart.vertex[next_corner(c)];
    visit(c, p, q);
    q = p;
  });
}

// The edges of a triangle (v, p, q) on the surface from `v`, and their products
class Surface_edges
{
public:
  Surface_edges(const Chart& chart, int v) : m_points(chart.points), m_v(v) {}

  // Goes to the next triangle around `v`. Its q is the p of the one before.
  void turn(int p, int q)
  {
    m_q = m_qq < 0 ? m_points[q] - m_points[m_v] : m_p;
    m_qq = m_qq < 0 ? m_q.squared_length() : m_pp;
    m_p = m_points[p] - m_points[m_v];
    m_pp = m_p.squared_length();
    m_pq = m_p * m_q;
  }

  // The dot products of the edges at the three corners: twice the area times their cotangents
  double dot_v() const { return m_pq; }
  double dot_p() const { return m_pp - m_pq; }
  double dot_q() const { return m_qq - m_pq; }
  double sum_of_squares() const { return m_pp + m_qq; }
  double twice_area() const { return std::sqrt(CGAL::cross_product(m_p, m_q).squared_length()); }

private:
  const std::vector<Chart::Point_3>& m_points;
  int m_v;
  Chart::Kernel::Vector_3 m_p, m_q;
  double m_pp = 0, m_pq = 0, m_qq = -1; // negative before the first triangle
};

// The ring of a star of any kind
struct Planar_star_base
{
  double over_relaxation = 1; // what the steps of the vertex are multiplied by
  bool on_border = false;
  double least_area = 0;                       // twice the area that a triangle must have in the plane
  int first_neighbour = 0, last_neighbour = 0; // the smallest and the largest number of a ring vertex

  // Calls `visit` with the corner at `v` of each triangle, clockwise, and its two other vertices.
  template <typename Visitor>
  void gather_ring(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v,
                   const Visitor& visit)
  {
    begin_ring(v, mesh.chart().interior[v] < 0);
    bool is_first = true;
    for_each_ring_triangle(mesh, v, [&](int c, int p, int q) {
      if(is_first)
        meet(q);
      is_first = false;
      take_ring_edge(uv, p, q);
      visit(c, p, q);
    });
  }

  // Calls `visit` also with the edges of each triangle from `v`.
  template <typename Visitor>
  void gather_surface_ring(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v,
                           const Visitor& visit)
  {
    Surface_edges edges(mesh.chart(), v);
    gather_ring(mesh, uv, v, [&](int c, int p, int q) {
      edges.turn(p, q);
      visit(c, p, q, edges);
    });
  }

protected:
  void begin_ring(int v, bool is_on_border)
  {
    on_border = is_on_border;
    first_neighbour = last_neighbour = v;
    least_area = 0;
  }

  void take_ring_edge(const std::vector<Planar_point>& uv, int p, int q)
  {
    meet(p);
    least_area = (std::max)(least_area,
                            1e-12 * (uv[p] - uv[q]).squaredNorm()); // far above the rounding errors of areas
  }

private:
  void meet(int neighbour)
  {
    first_neighbour = (std::min)(first_neighbour, neighbour);
    last_neighbour = (std::max)(last_neighbour, neighbour);
  }
};

// Whether all triangles of a star are positively oriented, by more than rounding errors, if its vertex is at `x`.
template <typename Star>
bool is_valid(const Star& star, const Planar_point& x)
{
  for(const auto& t : star.triangles)
    if(!(cross(t.p - x, t.q - x) > star.least_area))
      return false;
  return true;
}

// The winding number of the ring of a star around `x`: how many triangles lead from the lower half-plane to the upper
// one
template <typename Star>
int winding_number(const Star& star, const Planar_point& x)
{
  return static_cast<int>(std::count_if(star.triangles.begin(), star.triangles.end(), [&](const auto& t) {
    return !is_in_upper_half(t.p, x) && is_in_upper_half(t.q, x);
  }));
}

// The triangles around one vertex, in space and in the plane. The position where it is inserted depends on nothing
// else.
struct Planar_star : Planar_star_base
{
  // A triangle (v, p, q), counterclockwise.
  struct Triangle
  {
    Planar_point p, q;
    double cot_v, cot_p, cot_q; // of the angles on the surface
    double area;                // on the surface
  };

  std::vector<Triangle> triangles; // clockwise

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    triangles.clear();
    gather_ring(mesh, uv, v, [&](int, int p, int q) {
      triangles.push_back(make(mesh.chart(), v, p, q));
      triangles.back().p = uv[p];
      triangles.back().q = uv[q];
    });
  }

private:
  static Triangle make(const Chart& chart, int v, int p, int q)
  {
    const auto a = chart.points[p] - chart.points[v], b = chart.points[q] - chart.points[v];
    const double ab = a * b, aa = a.squared_length(), bb = b.squared_length();
    // The cotangents of needles are bounded, so that they are finite. A triangle that is a point counts as
    // equilateral.
    if(aa + bb == 0)
      return {Planar_point::Zero(), Planar_point::Zero(), std::sqrt(1. / 3),
              std::sqrt(1. / 3),    std::sqrt(1. / 3),    0};
    const double twice_area =
        (std::max)(std::sqrt(CGAL::cross_product(a, b).squared_length()), 1e-6 * (aa + bb));
    Triangle t{Planar_point::Zero(), Planar_point::Zero(), 0, 0, 0, 0};
    t.cot_v = ab / twice_area;
    t.cot_p = (aa - ab) / twice_area;
    t.cot_q = (bb - ab) / twice_area;
    t.area = twice_area / 2;
    return t;
  }
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_PLANAR_STAR_H
