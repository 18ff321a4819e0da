// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The data of baking: options, a surface with normals, the simple one with its charts, and the fine one with colors.
// The other headers of `baking/` know both meshes only in this form.
//
// Normals of vertices, and tangents of corners: the directions that normals in tangent space refer to.
// `bake_impl.h` bakes with these frames and hands them out, so that viewers can use the same.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_SHADED_SURFACES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_SHADED_SURFACES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace CGAL::Texture_atlas::internal {

typedef Eigen::Vector3d Space_vector;

// Triangles in space with a normal at each vertex
struct Shaded_surface
{
  std::vector<Space_vector> points;
  std::vector<Space_vector> normals; // of each point, of length 1; filled in if empty
  std::vector<int> vertex;           // three for each triangle

  int number_of_triangles() const { return static_cast<int>(vertex.size() / 3); }
};

// The simple surface, with its place in the texture
struct Charted_surface : Shaded_surface
{
  std::vector<Planar_point> uv; // of each corner, in the unit square
  std::vector<long> chart;      // of each triangle, or empty
};

// The fine surface
struct Painted_surface : Shaded_surface
{
  std::vector<Space_vector> colors; // of each point, or empty
};

// A vector of length 1, or `otherwise` for a vector that has no direction
inline Space_vector direction_of(const Space_vector& v, const Space_vector& otherwise)
{
  const double length = v.stableNorm();
  return length > 0 && std::isfinite(length) ? Space_vector(v / length) : otherwise;
}

// The angle of a triangle at its corner number k; 0 if it is degenerate
inline double angle_at(const std::array<Space_vector, 3>& p, int k)
{
  const Space_vector a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
  const double sine = a.cross(b).norm(), cosine = a.dot(b);
  return sine > 0 ? std::atan2(sine, cosine) : 0;
}

inline std::array<Space_vector, 3> corners_of(const Shaded_surface& surface, int t)
{
  const int* v = &surface.vertex[3 * static_cast<std::size_t>(t)];
  return {surface.points[v[0]], surface.points[v[1]], surface.points[v[2]]};
}

// Gives each vertex the mean of the normals around it, weighted by angles. Vertices without area around them get the
// direction of z.
inline void add_vertex_normals(Shaded_surface& surface)
{
  surface.normals.assign(surface.points.size(), Space_vector::Zero());
  for(int t = 0; t < surface.number_of_triangles(); ++t) {
    const std::array<Space_vector, 3> p = corners_of(surface, t);
    const Space_vector normal = direction_of((p[1] - p[0]).cross(p[2] - p[0]), Space_vector::Zero());
    for(int k = 0; k < 3; ++k)
      surface.normals[surface.vertex[3 * t + k]] += angle_at(p, k) * normal;
  }
  for(Space_vector& normal : surface.normals)
    normal = direction_of(normal, Space_vector::UnitZ());
}

// Computes the tangents of the corners of a surface. Corners at a vertex share a tangent if they are at the same place
// of the same chart, and their triangles have the same orientation.
class Tangent_maker
{
public:
  explicit Tangent_maker(const Charted_surface& surface) : m_surface(surface) {}

  std::vector<Tangent_frame> run()
  {
    find_tangents_of_triangles();
    std::vector<int> corners(m_surface.vertex.size());
    std::iota(corners.begin(), corners.end(), 0);
    std::sort(corners.begin(), corners.end(),
              [this](int c, int d) { return std::make_tuple(key(c), c) < std::make_tuple(key(d), d); });
    std::vector<Tangent_frame> frames(corners.size());
    for(auto first = corners.begin(); first != corners.end();) {
      auto last = first;
      Space_vector sum = Space_vector::Zero();
      for(; last != corners.end() && key(*last) == key(*first); ++last)
        sum += angle_at(corners_of(m_surface, *last / 3), *last % 3) * m_tangent[*last / 3];
      for(; first != last; ++first)
        frames[*first] = frame(m_surface.normals[m_surface.vertex[*first]], sum, m_sign[*first / 3]);
    }
    return frames;
  }

private:
  // The direction of growing u in each triangle, and whether the triangle is mirrored
  void find_tangents_of_triangles()
  {
    const int n = m_surface.number_of_triangles();
    m_tangent.resize(n);
    m_sign.resize(n);
    for(int t = 0; t < n; ++t) {
      const std::array<Space_vector, 3> p = corners_of(m_surface, t);
      const Planar_point* uv = &m_surface.uv[3 * static_cast<std::size_t>(t)];
      const Planar_point e = uv[1] - uv[0], f = uv[2] - uv[0];
      m_sign[t] = cross(e, f) < 0 ? -1 : 1;
      m_tangent[t] =
          direction_of(m_sign[t] * (f.y() * (p[1] - p[0]) - e.y() * (p[2] - p[0])), Space_vector::Zero());
    }
  }

  std::tuple<int, long, double, double, int> key(int c) const
  {
    return {m_surface.vertex[c], m_surface.chart.empty() ? 0 : m_surface.chart[c / 3], m_surface.uv[c].x(),
            m_surface.uv[c].y(), m_sign[c / 3]};
  }

  static Tangent_frame frame(const Space_vector& normal, const Space_vector& tangent, int sign)
  {
    const Space_vector other =
        Space_vector::Unit(std::abs(normal.x()) < 0.6 ? 0 : 1); // is not nearly parallel to the normal
    const auto orthogonal = [&normal](const Space_vector& v) {
      return Space_vector(v - normal.dot(v) * normal);
    };
    Space_vector t = orthogonal(direction_of(tangent, Space_vector::Zero()));
    t = direction_of(orthogonal(direction_of(t.norm() > 1e-6 ? t : other, other)), other);
    return {{normal.x(), normal.y(), normal.z()}, {t.x(), t.y(), t.z()}, static_cast<double>(sign)};
  }

  const Charted_surface& m_surface;
  std::vector<Space_vector> m_tangent;
  std::vector<int> m_sign;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_SHADED_SURFACES_H
