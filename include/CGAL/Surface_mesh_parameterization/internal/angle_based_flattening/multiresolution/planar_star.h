// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_PLANAR_STAR_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_PLANAR_STAR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

typedef Eigen::Vector2d Planar_point;

inline double cross(const Planar_point& a, const Planar_point& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

// What all kinds of stars know about their ring.
struct Planar_star_base
{
  bool on_border = false;
  double least_area = 0;                       // twice the area that a triangle must have in the plane
  int first_neighbour = 0, last_neighbour = 0; // the smallest and the largest number of a ring vertex

  // Calls `visit` with the corner at `v` of each triangle, clockwise, and its two other vertices.
  template <typename Visitor>
  void gather_ring(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v,
                   const Visitor& visit)
  {
    const Chart& chart = mesh.chart();
    on_border = chart.interior[v] < 0;
    first_neighbour = last_neighbour = v;
    double longest = 0;
    int q = -1; // each triangle starts where the previous one ended
    mesh.for_each_corner(v, [&](int c) {
      if(q < 0)
        meet(q = chart.vertex[previous_corner(c)]);
      const int p = chart.vertex[next_corner(c)];
      meet(p);
      longest = (std::max)(longest, (uv[p] - uv[q]).squaredNorm());
      visit(c, p, q);
      q = p;
    });
    least_area = 1e-12 * longest; // far above the rounding errors of areas
  }

  // The edges from a vertex to `p` and `q` on the surface, and their products
  struct Surface_edges
  {
    Chart::Kernel::Vector_3 p, q;
    double pp, pq, qq;

    double twice_area() const { return std::sqrt(CGAL::cross_product(p, q).squared_length()); }
  };

  // Calls `visit` also with the edges of each triangle from `v`.
  template <typename Visitor>
  void gather_surface_ring(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v,
                           const Visitor& visit)
  {
    const std::vector<Chart::Point_3>& points = mesh.chart().points;
    Surface_edges edges{};
    bool is_first = true;
    gather_ring(mesh, uv, v, [&](int c, int p, int q) {
      edges.q = is_first ? points[q] - points[v] : edges.p;
      edges.qq = is_first ? edges.q.squared_length() : edges.pp;
      edges.p = points[p] - points[v];
      edges.pp = edges.p.squared_length();
      edges.pq = edges.p * edges.q;
      is_first = false;
      visit(c, p, q, edges);
    });
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
