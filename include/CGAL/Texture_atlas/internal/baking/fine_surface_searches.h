// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The two searches on the fine surface: along a ray to both sides, and for the closest point. Rays do not slip through
// common edges. `fine_surface_searches.h` runs them in CGAL's tree.
//
// CGAL's tree over the triangles of the fine surface, with searches that tell front faces from back faces.
// `bake_impl.h` asks it once or twice for each texel.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_FINE_SURFACE_SEARCHES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_FINE_SURFACE_SEARCHES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/baking/shaded_surfaces.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#include <boost/iterator/counting_iterator.hpp>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL::Texture_atlas::internal {

// A triangle of the fine surface, as a primitive of CGAL's tree
class Fine_triangle
{
public:
  typedef int Id;
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  typedef CGAL::Simple_cartesian<double>::Triangle_3 Datum;

  Fine_triangle(boost::counting_iterator<int> number, const Shaded_surface& surface)
      : m_surface(&surface), m_id(*number)
  {}

  Id id() const { return m_id; }
  const Space_vector& corner(int k) const
  {
    return m_surface->points[m_surface->vertex[3 * static_cast<std::size_t>(m_id) + k]];
  }
  Datum datum() const { return Datum(point(0), point(1), point(2)); }
  Point reference_point() const { return point(0); }

private:
  Point point(int k) const { return Point(corner(k).x(), corner(k).y(), corner(k).z()); }

  const Shaded_surface* m_surface;
  int m_id;
};

// A point on the fine surface
struct Fine_point
{
  int triangle = -1;
  std::array<double, 3> weights = {0, 0, 0}; // of its corners
  double distance = 0;                       // along the ray, with a sign, or to the closest point
  bool is_back_face = false;

  bool is_found() const { return triangle >= 0; }
};

// What a ray to both sides meets: the nearest triangle with a normal along the ray, and the nearest with a normal
// against it. A ray through a common edge of two triangles meets at least one of them, because both compute the same
// numbers for the edge.
class Ray_search
{
public:
  typedef double Priority;

  Ray_search(const Space_vector& origin, const Space_vector& direction, double reach)
      : m_origin(origin), m_direction(direction), m_bound(reach)
  {
    m_front.distance = m_back.distance = reach;
    direction.cwiseAbs().maxCoeff(&m_z);
    m_x = (m_z + 1) % 3;
    m_y = (m_z + 2) % 3;
    m_shear = {direction[m_x] / direction[m_z], direction[m_y] / direction[m_z], 1 / direction[m_z]};
    for(int k = 0; k < 3; ++k)
      m_inverse[k] =
          1 / (std::abs(direction[k]) > 1e-100 ? direction[k] : std::copysign(1e-100, direction[k]));
  }

  // What is taken
  Fine_point result() const
  {
    Fine_point point = m_front.is_found() ? m_front : m_back;
    point.is_back_face = !m_front.is_found() && m_back.is_found();
    return point;
  }

  bool go_further() const { return true; }

  template <typename Node>
  bool do_intersect(bool, const Node& node) const
  {
    return near_distance(node.bbox()) <= m_bound;
  }

  template <typename Node>
  std::pair<bool, Priority> do_intersect_with_priority(bool, const Node& node) const
  {
    const double distance = near_distance(node.bbox());
    return {distance <= m_bound, -distance};
  }

  void intersection(bool, const Fine_triangle& triangle)
  {
    const std::array<double, 3> a = sheared(triangle.corner(0)), b = sheared(triangle.corner(1)),
                                c = sheared(triangle.corner(2));
    const double u = c[0] * b[1] - c[1] * b[0], v = a[0] * c[1] - a[1] * c[0], w = b[0] * a[1] - b[1] * a[0];
    if((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0))
      return;
    const double sum = u + v + w;
    if(sum == 0)
      return;
    Fine_point point;
    point.triangle = triangle.id();
    point.weights = {u / sum, v / sum, w / sum};
    point.distance = point.weights[0] * a[2] + point.weights[1] * b[2] + point.weights[2] * c[2];
    const Space_vector normal =
        (triangle.corner(1) - triangle.corner(0)).cross(triangle.corner(2) - triangle.corner(0));
    const bool is_front = normal.dot(m_direction) > 0;
    take(point, is_front ? m_front : m_back);
    if(m_front.is_found())
      m_bound = std::abs(m_front.distance);
  }

private:
  // Of several at the same distance, the first one is taken: the order of the search does not matter.
  static void take(const Fine_point& point, Fine_point& nearest)
  {
    const double distance = std::abs(point.distance), before = std::abs(nearest.distance);
    if(distance < before ||
       (distance == before && (!nearest.is_found() || point.triangle < nearest.triangle)))
      nearest = point;
  }

  std::array<double, 3> sheared(const Space_vector& p) const
  {
    const Space_vector q = p - m_origin;
    return {q[m_x] - m_shear[0] * q[m_z], q[m_y] - m_shear[1] * q[m_z], m_shear[2] * q[m_z]};
  }

  // How far from the origin the line enters a box, to either side; infinite if it does not
  double near_distance(const CGAL::Bbox_3& box) const
  {
    double first = -std::numeric_limits<double>::infinity(), last = -first;
    for(int k = 0; k < 3; ++k) {
      const double s = ((box.min)(k)-rounding - m_origin[k]) * m_inverse[k],
                   t = ((box.max)(k) + rounding - m_origin[k]) * m_inverse[k];
      first = (std::max)(first, (std::min)(s, t));
      last = (std::min)(last, (std::max)(s, t));
    }
    return first > last ? std::numeric_limits<double>::infinity() : (std::max)({first, -last, 0.});
  }

  static constexpr double rounding = 1e-13; // of coordinates near the simple surface

  const Space_vector m_origin, m_direction;
  Space_vector m_inverse, m_shear;
  int m_x, m_y, m_z;
  double m_bound;
  Fine_point m_front, m_back;
};

// The point of the fine surface that is closest to a point
class Closest_point_search
{
public:
  typedef double Priority;

  explicit Closest_point_search(const Space_vector& origin) : m_origin(origin) {}

  Fine_point result() const
  {
    Fine_point point = m_closest;
    point.distance = std::sqrt(m_bound);
    return point;
  }

  bool go_further() const { return true; }

  template <typename Node>
  bool do_intersect(bool, const Node& node) const
  {
    return squared_distance(node.bbox()) <= m_bound;
  }

  template <typename Node>
  std::pair<bool, Priority> do_intersect_with_priority(bool, const Node& node) const
  {
    const double distance = squared_distance(node.bbox());
    return {distance <= m_bound, -distance};
  }

  void intersection(bool, const Fine_triangle& triangle)
  {
    const std::array<Space_vector, 3> p = {triangle.corner(0), triangle.corner(1), triangle.corner(2)};
    const Space_vector e = p[1] - p[0], f = p[2] - p[0], normal = e.cross(f), d = m_origin - p[0];
    const double area = normal.squaredNorm();
    const double v = d.cross(f).dot(normal) / area, w = e.cross(d).dot(normal) / area;
    if(v >= 0 && w >= 0 && v + w <= 1) {
      take(triangle.id(), {1 - v - w, v, w}, p);
      return;
    }
    for(int k = 0; k < 3; ++k) {
      const Space_vector& a = p[k];
      const Space_vector side = p[(k + 1) % 3] - a;
      const double s = (std::min)((std::max)(side.dot(m_origin - a) / side.squaredNorm(), 0.), 1.);
      std::array<double, 3> weights = {0, 0, 0};
      weights[k] = 1 - s;
      weights[(k + 1) % 3] = s;
      take(triangle.id(), weights, p);
    }
  }

private:
  void take(int triangle, const std::array<double, 3>& weights, const std::array<Space_vector, 3>& p)
  {
    const double distance =
        (weights[0] * p[0] + weights[1] * p[1] + weights[2] * p[2] - m_origin).squaredNorm();
    if(distance < m_bound || (distance == m_bound && triangle < m_closest.triangle)) {
      m_bound = distance;
      m_closest.triangle = triangle;
      m_closest.weights = weights;
    }
  }

  double squared_distance(const CGAL::Bbox_3& box) const
  {
    double sum = 0;
    for(int k = 0; k < 3; ++k) {
      const double d = (std::max)({(box.min)(k)-m_origin[k], m_origin[k] - (box.max)(k), 0.});
      sum += d * d;
    }
    return sum;
  }

  const Space_vector m_origin;
  double m_bound = std::numeric_limits<double>::infinity();
  Fine_point m_closest;
};

} // namespace CGAL::Texture_atlas::internal

#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <boost/iterator/counting_iterator.hpp>

namespace CGAL::Texture_atlas::internal {

// Finds points on the fine surface. CGAL's tree, with searches of our own: its own queries return the nearest triangle
// on one side, or all triangles, and do not tell front faces from back faces.
class Fine_surface_tree
{
  typedef CGAL::Simple_cartesian<double> Kernel;
#if CGAL_VERSION_NR >= 1060000000
  typedef CGAL::AABB_traits_3<Kernel, Fine_triangle> Traits;
#else
  typedef CGAL::AABB_traits<Kernel, Fine_triangle> Traits;
#endif

public:
  explicit Fine_surface_tree(const Shaded_surface& surface)
      : m_tree(boost::counting_iterator<int>(0), boost::counting_iterator<int>(surface.number_of_triangles()),
               surface)
  {
    m_tree.build();
  }

  Fine_point along_ray(const Space_vector& origin, const Space_vector& direction, double reach) const
  {
    return found(Ray_search(origin, direction, reach));
  }

  Fine_point closest(const Space_vector& origin) const
  {
    return found(Closest_point_search(origin));
  }

private:
  template <typename Search>
  Fine_point found(Search search) const
  {
    m_tree.traversal_with_priority(true, search); // the searches know their queries
    return search.result();
  }

  CGAL::AABB_tree<Traits> m_tree;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_FINE_SURFACE_SEARCHES_H
