// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_TEXTURED_SURFACE_H
#define PICTURES_TEXTURED_SURFACE_H

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <CGAL/Origin.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pictures {

using namespace CGAL::Texture_atlas::internal::prepare;

// Triangles with coordinates in the plane, as arrays: what pictures are made of.
struct Textured_surface
{
  using Index = std::uint32_t;

  // The side of a triangle from one of its corners to the next.
  struct Side
  {
    Index triangle;
    std::uint8_t corner;
    int seam; // a number that both sides of a seam have; -1 at borders of the surface
  };

  struct Border
  {
    int chart;
    std::vector<Side> sides; // in their order around the chart
  };

  std::vector<Kernel::Point_3> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::array<Kernel::Point_2, 3>> uv; // of the corners of each triangle
  std::vector<int> charts; // of each triangle; -1 without one, and then without coordinates
  std::vector<Border> borders;

  Kernel::Vector_3 doubled_area_vector(const std::size_t triangle) const
  {
    const auto& [a, b, c] = triangles[triangle];
    return CGAL::cross_product(points[b] - points[a], points[c] - points[a]);
  }

  const Kernel::Point_2& start(const Side& side) const { return uv[side.triangle][side.corner]; }

  const Kernel::Point_2& end(const Side& side) const { return uv[side.triangle][(side.corner + 1u) % 3]; }
};

// At each point, the sum of the doubled area vectors of its triangles
inline std::vector<Kernel::Vector_3> point_normals(const Textured_surface& surface)
{
  std::vector<Kernel::Vector_3> normals(surface.points.size(), CGAL::NULL_VECTOR);
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const Kernel::Vector_3 normal = surface.doubled_area_vector(t);
    for(const Textured_surface::Index v : surface.triangles[t]) {
      normals[v] = normals[v] + normal;
    }
  }
  return normals;
}

// Of the triangles with charts: the area on the surface, and that in the plane
struct Textured_areas
{
  double space = 0, plane = 0;
};

inline Textured_areas textured_areas(const Textured_surface& surface)
{
  Textured_areas areas;
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    if(surface.charts[t] >= 0) {
      const auto& [a, b, c] = surface.uv[t];
      areas.space += std::sqrt(surface.doubled_area_vector(t).squared_length()) / 2;
      areas.plane += std::abs(CGAL::determinant(b - a, c - a)) / 2;
    }
  }
  return areas;
}

} // namespace pictures

#endif // PICTURES_TEXTURED_SURFACE_H
