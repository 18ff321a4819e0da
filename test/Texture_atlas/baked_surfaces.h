// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_TEST_BAKED_SURFACES_H
#define ANGLE_BASED_FLATTENING_TEST_BAKED_SURFACES_H

// Surfaces for tests of baking, and what a viewer makes of baked textures.

#include <CGAL/Texture_atlas/Baked_textures.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace baked_surfaces {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace TA = CGAL::Texture_atlas;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using Halfedge = Surface::Halfedge_index;
using Face = Surface::Face_index;
using Vector = Eigen::Vector3d;
using Plane_point = Eigen::Vector2d;

inline Vector vector_of(const Kernel::Point_3& p)
{
  return {p.x(), p.y(), p.z()};
}

inline double degrees_between(const Vector& a, const Vector& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / CGAL_PI;
}

// A sphere of radius 1 whose 20 * 4^levels triangles are nearly equilateral
inline Surface sphere(int levels)
{
  Surface surface;
  CGAL::make_icosahedron(surface, Kernel::Point_3(0, 0, 0));
  for(int level = 0; level < levels; ++level) {
    Surface finer;
    std::map<std::pair<Vertex, Vertex>, Vertex> middles;
    for(const Vertex v : surface.vertices())
      finer.add_vertex(surface.point(v));
    const auto middle = [&](Vertex v, Vertex w) {
      const auto [place, is_new] = middles.emplace(std::minmax(v, w), Vertex());
      if(is_new)
        place->second = finer.add_vertex(CGAL::midpoint(surface.point(v), surface.point(w)));
      return place->second;
    };
    for(const Face f : surface.faces()) {
      std::array<Vertex, 3> v;
      std::size_t i = 0;
      for(const Vertex w : surface.vertices_around_face(surface.halfedge(f)))
        v[i++] = w;
      const Vertex a = middle(v[0], v[1]), b = middle(v[1], v[2]), c = middle(v[2], v[0]);
      finer.add_face(v[0], a, c);
      finer.add_face(v[1], b, a);
      finer.add_face(v[2], c, b);
      finer.add_face(a, b, c);
    }
    surface = finer;
  }
  for(const Vertex v : surface.vertices()) {
    const Vector p = vector_of(surface.point(v)).normalized();
    surface.point(v) = Kernel::Point_3(p.x(), p.y(), p.z());
  }
  return surface;
}

// A graph over the unit square, of 2 * cells^2 triangles that look upwards
template <typename Height>
Surface sheet(int cells, const Height& height)
{
  Surface surface;
  std::vector<Vertex> v;
  for(int j = 0; j <= cells; ++j)
    for(int i = 0; i <= cells; ++i) {
      const double x = static_cast<double>(i) / cells, y = static_cast<double>(j) / cells;
      v.push_back(surface.add_vertex(Kernel::Point_3(x, y, height(x, y))));
    }
  for(int j = 0; j < cells; ++j)
    for(int i = 0; i < cells; ++i) {
      const std::size_t a = static_cast<std::size_t>(j) * (cells + 1) + i, b = a + cells + 1;
      surface.add_face(v[a], v[a + 1], v[b + 1]);
      surface.add_face(v[a], v[b + 1], v[b]);
    }
  return surface;
}

using Uv_map = Surface::Property_map<Halfedge, Kernel::Point_2>;
using Frame_map = Surface::Property_map<Halfedge, TA::Tangent_frame>;

inline Uv_map uv_map(Surface& surface)
{
  return surface.add_property_map<Halfedge, Kernel::Point_2>("h:uv", Kernel::Point_2(0, 0)).first;
}

inline Frame_map frame_map(Surface& surface)
{
  return surface.add_property_map<Halfedge, TA::Tangent_frame>("h:frame").first;
}

// Texture coordinates of a sheet: those of `place` at its x and y
template <typename Place>
Uv_map project(Surface& surface, const Place& place)
{
  const Uv_map uv = uv_map(surface);
  for(const Halfedge h : surface.halfedges())
    if(!surface.is_border(h)) {
      const Kernel::Point_3& p = surface.point(surface.target(h));
      const Plane_point q = place(p.x(), p.y());
      uv[h] = Kernel::Point_2(q.x(), q.y());
    }
  return uv;
}

// A point in a face: the weights of its corners, as the loop of its halfedges comes
struct Place
{
  Face face;
  std::array<double, 3> weights;
};

inline std::array<Halfedge, 3> corners(const Surface& surface, Face f)
{
  const Halfedge h = surface.halfedge(f);
  return {h, surface.next(h), surface.next(surface.next(h))};
}

inline Place random_place(const Surface& surface, std::mt19937& random)
{
  std::uniform_real_distribution<double> unit(0, 1);
  const double r = std::sqrt(unit(random)), s = unit(random);
  const auto f = static_cast<Surface::size_type>(random() % surface.number_of_faces());
  return {Face(f), {1 - r, r * (1 - s), r * s}};
}

// The mean of values of the corners
template <typename Value, typename Value_of>
Value mean(const Surface& surface, const Place& place, const Value& zero, const Value_of& value_of)
{
  Value sum = zero;
  std::size_t k = 0;
  for(const Halfedge h : corners(surface, place.face))
    sum += place.weights[k++] * value_of(h);
  return sum;
}

inline Vector point_at(const Surface& surface, const Place& place)
{
  return mean(surface, place, Vector(0, 0, 0),
              [&](Halfedge h) { return vector_of(surface.point(surface.target(h))); });
}

inline Plane_point uv_at(const Surface& surface, const Uv_map& uv, const Place& place)
{
  return mean(surface, place, Plane_point(0, 0),
              [&](Halfedge h) { return Plane_point(uv[h].x(), uv[h].y()); });
}

inline Vector normal_at(const Surface& surface, const Frame_map& frames, const Place& place)
{
  return mean(surface, place, Vector(0, 0, 0), [&](Halfedge h) { return Vector(frames[h].normal.data()); })
      .normalized();
}

// What a viewer reads at a place of a texture, whose pixels have three channels: interpolated between the centres of
// texels, or that of the texel
template <typename Channel>
Vector read_texture(const std::vector<Channel>& pixels, int resolution, const Plane_point& uv,
                    bool interpolates)
{
  const auto pixel = [&](int x, int y) {
    x = (std::min)((std::max)(x, 0), resolution - 1);
    y = (std::min)((std::max)(y, 0), resolution - 1);
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * resolution + x);
    return Vector(pixels[i], pixels[i + 1], pixels[i + 2]);
  };
  const double x = uv.x() * resolution, y = (1 - uv.y()) * resolution;
  if(!interpolates)
    return pixel(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y)));
  const int i = static_cast<int>(std::floor(x - 0.5)), j = static_cast<int>(std::floor(y - 0.5));
  const double s = x - 0.5 - i, t = y - 0.5 - j;
  return (1 - t) * ((1 - s) * pixel(i, j) + s * pixel(i + 1, j)) +
         t * ((1 - s) * pixel(i, j + 1) + s * pixel(i + 1, j + 1));
}

// The normal in space that a viewer shows: of a pixel from 0 to `largest`
inline Vector shown_normal(const Surface& surface, const Frame_map& frames, const Place& place,
                           const Vector& pixel, double largest)
{
  const Vector n = 2 * pixel / largest - Vector(1, 1, 1);
  const Vector tangent = mean(surface, place, Vector(0, 0, 0), [&](Halfedge h) {
                           return Vector(frames[h].tangent.data());
                         }).normalized();
  const Vector bitangent =
      mean(surface, place, Vector(0, 0, 0), [&](Halfedge h) {
        const Vector at_corner(frames[h].normal.data());
        return Vector(frames[h].sign * at_corner.cross(Vector(frames[h].tangent.data())));
      }).normalized();
  return (n.x() * tangent + n.y() * bitangent + n.z() * normal_at(surface, frames, place)).normalized();
}

} // namespace baked_surfaces

#endif // ANGLE_BASED_FLATTENING_TEST_BAKED_SURFACES_H
