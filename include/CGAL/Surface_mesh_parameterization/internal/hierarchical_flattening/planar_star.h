// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_PLANAR_STAR_H
#define CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_PLANAR_STAR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/edge_collapses.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

typedef Eigen::Vector2d Planar_point;

inline double cross(const Planar_point& a, const Planar_point& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

// The triangles around one vertex, in space and in the plane: all that its place in the plane depends on.
struct Planar_star
{
  // A triangle (v, p, q), counterclockwise.
  struct Triangle
  {
    Planar_point p, q;
    double cot_v, cot_p, cot_q; // of the angles on the surface
    double area;                // on the surface
  };

  std::vector<Triangle> triangles; // clockwise
  bool on_border = false;
  double least_area = 0;                       // twice the area that a triangle must have in the plane
  int first_neighbour = 0, last_neighbour = 0; // the smallest and largest number of a vertex around

  void gather(const Edge_collapses& mesh, const std::vector<Planar_point>& uv, int v)
  {
    const Chart& chart = mesh.chart();
    triangles.clear();
    on_border = chart.interior[v] < 0;
    double longest = 0;
    first_neighbour = last_neighbour = v;
    mesh.for_each_corner(v, [&](int c) {
      const int p = chart.vertex[next_corner(c)], q = chart.vertex[previous_corner(c)];
      first_neighbour = (std::min)({first_neighbour, p, q});
      last_neighbour = (std::max)({last_neighbour, p, q});
      triangles.push_back(make(chart, v, p, q));
      triangles.back().p = uv[p];
      triangles.back().q = uv[q];
      longest = (std::max)(longest, (uv[p] - uv[q]).squaredNorm());
    });
    least_area = 1e-12 * longest; // far above the rounding errors of areas
  }

  bool is_valid(const Planar_point& x) const
  {
    for(const Triangle& t : triangles)
      if(!(cross(t.p - x, t.q - x) > least_area))
        return false;
    return true;
  }

private:
  static Triangle make(const Chart& chart, int v, int p, int q)
  {
    const auto a = chart.points[p] - chart.points[v], b = chart.points[q] - chart.points[v];
    const double ab = a * b, aa = a.squared_length(), bb = b.squared_length();
    // The cotangents of needles are bounded; what counts is that they are finite.
    const double twice_area =
        (std::max)(std::sqrt(CGAL::cross_product(a, b).squared_length()), 1e-6 * (aa + bb));
    Triangle t;
    t.cot_v = ab / twice_area;
    t.cot_p = (aa - ab) / twice_area;
    t.cot_q = (bb - ab) / twice_area;
    t.area = twice_area / 2;
    return t;
  }
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_PLANAR_STAR_H
