// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_SOUP_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

using Kernel = Exact_predicates_inexact_constructions_kernel;

// The number of a point, polygon, corner and so on, from 0. Half as large as `std::size_t`: models are large.
using Index = std::uint32_t;
constexpr Index no_index = static_cast<Index>(-1);

// Points and polygons that may be a surface, as a file or arrays hold them. Repairs do not change them. Corners are
// numbered through, polygon by polygon.
struct Surface_soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<Kernel::Point_2> texture;

  std::vector<Index> first_corners = {0}; // of each polygon, and the number of corners
  std::vector<Index> vertices;            // the point of each corner
  std::vector<Index> corner_texture;      // of each corner, or empty
  bool has_point_texture = false;         // texture belongs to the points, in their order

  std::vector<std::string> material_names; // each once
  std::vector<Index> materials;            // of each polygon, or empty

  std::string file;       // its name
  bool is_welded = false; // from a file without indices, such as STL: the reader merged equal points

  std::size_t number_of_polygons() const { return first_corners.size() - 1; }
  std::size_t number_of_corners() const { return vertices.size(); }

  Index size(const Index polygon) const { return first_corners[polygon + 1] - first_corners[polygon]; }

  Index polygon_of_corner(const Index corner) const
  {
    const auto after = std::upper_bound(first_corners.begin(), first_corners.end(), corner);
    return static_cast<Index>(after - first_corners.begin()) - 1;
  }

  // In `texture`
  Index texture_point(const Index corner) const
  {
    return has_point_texture ? vertices[corner] : corner_texture.empty() ? no_index : corner_texture[corner];
  }

  // In `material_names`
  Index material(const Index polygon) const { return materials.empty() ? no_index : materials[polygon]; }

  // Its corners have to be in `vertices` already.
  void end_polygon()
  {
    if(vertices.size() >= no_index) {
      throw Input_error("'" + file + "': the file has more than 4294967294 corners of faces; split the mesh");
    }
    first_corners.push_back(static_cast<Index>(vertices.size()));
  }
};

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_SOUP_H
