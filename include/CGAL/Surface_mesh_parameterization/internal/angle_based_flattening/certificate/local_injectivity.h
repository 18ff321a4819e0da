// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact orientations of triangles, and winding numbers of vertices: what makes a map injective near every point.
// The rest of the certificate builds on it, and so do overlaps, polygons and injective maps.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_LOCAL_INJECTIVITY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_LOCAL_INJECTIVITY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/planar_kernel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Kernel_traits.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Points of any kernel, as they are, in a kernel with exact predicates: their own if its numbers are exact, and
// otherwise one that holds all numbers that a `double` does.
template <typename Point>
struct Exact_point
{
  typedef typename CGAL::Kernel_traits<Point>::Kernel Kernel;
  typedef typename Kernel::FT FT;
  static constexpr bool is_double =
      std::is_arithmetic<FT>::value && std::numeric_limits<FT>::digits <= std::numeric_limits<double>::digits;
  static_assert(is_double ||
                    (!std::is_arithmetic<FT>::value && CGAL::Algebraic_structure_traits<FT>::Is_exact::value),
                "the coordinates must be exact numbers, or numbers that `double` can hold");
  typedef std::conditional_t<is_double, Planar_kernel::Point_2, Point> type;

  static type get(const Point& p)
  {
    if constexpr(is_double)
      return type(static_cast<double>(p.x()), static_cast<double>(p.y()));
    else
      return p;
  }
};

typedef Exact_point<Corner_table::Point_2>::type Exact_point_2;

inline Exact_point_2 exact_point(const Corner_table::Point_2& p)
{
  return Exact_point<Corner_table::Point_2>::get(p);
}

inline std::vector<Exact_point_2> exact_points(const std::vector<Corner_table::Point_2>& uv)
{
  std::vector<Exact_point_2> points;
  points.reserve(uv.size());
  for(const Corner_table::Point_2& p : uv)
    points.push_back(exact_point(p));
  return points;
}

// An edge on the border, from vertex to vertex, with its triangle to the left.
struct Border_edge
{
  int source;
  int target;
};

// In the order of the chart's border cycles.
inline std::vector<Border_edge> border_edges(const Corner_table& chart)
{
  std::vector<Border_edge> edges;
  for(const std::vector<int>& border : chart.borders)
    for(int c : border)
      edges.push_back({chart.edge_source(c), chart.edge_target(c)});
  return edges;
}

template <typename Point>
bool is_finite_point(const Point& p)
{
  return CGAL::is_finite(p.x()) && CGAL::is_finite(p.y());
}

// By an exact predicate
template <typename Point>
bool is_positively_oriented(const Point& p, const Point& q, const Point& r)
{
  static_assert(std::is_same<typename Exact_point<Point>::type, Point>::value, "predicates must be exact");
  return is_finite_point(p) && is_finite_point(q) && is_finite_point(r) &&
         CGAL::orientation(p, q, r) == CGAL::LEFT_TURN;
}

// The triangles that are not positively oriented in the plane. Coordinates that are not finite make a triangle
// count as flipped. `vertex` holds the vertex of each corner.
template <typename Point>
std::vector<int> flipped_triangles(const std::vector<int>& vertex, const std::vector<Point>& uv)
{
  std::vector<int> flipped;
  for(std::size_t c = 0; c < vertex.size(); c += 3)
    if(!is_positively_oriented(uv[vertex[c]], uv[vertex[c + 1]], uv[vertex[c + 2]]))
      flipped.push_back(static_cast<int>(c / 3));
  return flipped;
}

inline std::vector<int> flipped_triangles(const Corner_table& chart,
                                          const std::vector<Corner_table::Point_2>& uv)
{
  return flipped_triangles(chart.vertex, exact_points(uv));
}

// How often the triangles around each vertex sweep over the direction of the x-axis. A triangle takes less than half
// a turn, and so does it exactly if it leads from the lower half of the plane to the upper one.
template <typename Point>
std::vector<int> winding_numbers(const std::vector<int>& vertex, const std::vector<Point>& uv)
{
  std::vector<int> sweeps(uv.size(), 0);
  for(int c = 0; c < static_cast<int>(vertex.size()); ++c) {
    const Point& origin = uv[vertex[c]];
    if(!is_in_upper_half(uv[vertex[next_corner(c)]], origin) &&
       is_in_upper_half(uv[vertex[previous_corner(c)]], origin))
      ++sweeps[vertex[c]];
  }
  return sweeps;
}

// A border edge as a ray from a vertex, where triangles begin or end, counterclockwise.
struct Border_ray
{
  int vertex;
  int to;
  bool begins;
};

// By vertices and, around each, counterclockwise from the direction of the x-axis
template <typename Point>
struct Is_ray_before
{
  const std::vector<Point>& uv;

  bool operator()(const Border_ray& r, const Border_ray& s) const
  {
    if(r.vertex != s.vertex)
      return r.vertex < s.vertex;
    const Point& origin = uv[r.vertex];
    const bool upper = is_in_upper_half(uv[r.to], origin);
    if(upper != is_in_upper_half(uv[s.to], origin))
      return upper;
    return CGAL::orientation(origin, uv[r.to], uv[s.to]) == CGAL::LEFT_TURN;
  }
};

// Whether positively oriented triangles overlap at no vertex: they go around each interior vertex once, and the fans
// around each border vertex follow one another, each ending before the next one begins.
template <typename Point>
bool is_injective_at_vertices(const std::vector<int>& vertex, const std::vector<Border_edge>& border,
                              const std::vector<Point>& uv)
{
  const std::vector<int> sweeps = winding_numbers(vertex, uv);
  if(std::any_of(sweeps.begin(), sweeps.end(), [](int number) { return number > 1; }))
    return false;
  std::vector<Border_ray> rays;
  for(const Border_edge& edge : border) {
    rays.push_back({edge.source, edge.target, true});
    rays.push_back({edge.target, edge.source, false});
  }
  const Is_ray_before<Point> is_before{uv};
  std::sort(rays.begin(), rays.end(), is_before);
  for(std::size_t i = 0; i < rays.size(); ++i) {
    const bool is_first = i == 0 || rays[i - 1].vertex != rays[i].vertex;
    const bool is_in_fan = is_first ? sweeps[rays[i].vertex] == 1 : rays[i - 1].begins;
    if(rays[i].begins == is_in_fan || (!is_first && !is_before(rays[i - 1], rays[i])))
      return false;
  }
  return true;
}

#ifdef CGAL_ANGLE_BASED_FLATTENING_COMPILED
extern template std::vector<int> flipped_triangles(const std::vector<int>&,
                                                   const std::vector<Exact_point_2>&);
extern template bool is_injective_at_vertices(const std::vector<int>&, const std::vector<Border_edge>&,
                                              const std::vector<Exact_point_2>&);
#endif

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_LOCAL_INJECTIVITY_H
