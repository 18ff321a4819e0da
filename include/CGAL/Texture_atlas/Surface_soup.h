// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SURFACE_SOUP_H
#define CGAL_TEXTURE_ATLAS_SURFACE_SOUP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

/// \file Surface_soup.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// Points and polygons that may be a surface, as files and arrays hold them: the input of `make_atlas()`.
///
/// Polygons may have any number of corners, be oriented differently, overlap, repeat one another, or share no vertices.
/// Corners are numbered through, polygon by polygon. All numbers count from 0.
///
/// \code{.cpp}
/// Surface_soup soup;
/// soup.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
/// soup.add_polygon({0, 1, 2, 3});
/// \endcode
struct Surface_soup
{
  typedef Exact_predicates_inexact_constructions_kernel Kernel; ///< The kernel of all coordinates

  /// The number of a point, polygon or corner. Half as large as `std::size_t`: soups are large.
  typedef std::uint32_t Index;

  /// No number: in `corner_texture` of a corner without coordinates, in `materials` of a polygon without material.
  static constexpr Index none = static_cast<Index>(-1);

  std::vector<Kernel::Point_3> points; ///< The points.

  /// The first corner of each polygon, and, after the last one, the number of all corners.
  std::vector<Index> first_corners = {0};
  std::vector<Index> vertices; ///< The number of the point of each corner.

  /// Coordinates in the plane that the surface has already, if any: see `Atlas_options::given_charts`,
  /// `Soup_options::texture_seams` and `is_ignored`.
  std::vector<Kernel::Point_2> texture;
  std::vector<Index> corner_texture; ///< The number of the coordinates of each corner, or empty.
  bool has_point_texture = false;    ///< Whether `texture` belongs to the points, in their order.

  std::vector<std::string> material_names; ///< The names of materials, each once.
  std::vector<Index> materials;            ///< The number of the material of each polygon, or empty.

  /// Edges that are seams in any case, each as the numbers of two points.
  std::vector<std::pair<Index, Index>> marked_seams;

  /// Of each polygon: whether it gets no chart. It keeps the coordinates in `texture`. Empty if all get charts.
  std::vector<bool> is_ignored;

  std::string name; ///< A name for messages, if there are several soups.

  /// Whether equal points were merged when the soup was made, as from files without vertices, such as STL.
  bool is_welded = false;

  /// returns the number of polygons.
  std::size_t number_of_polygons() const { return first_corners.size() - 1; }

  /// returns the number of corners of all polygons.
  std::size_t number_of_corners() const { return vertices.size(); }

  /// returns the number of corners of a polygon.
  Index size(Index polygon) const { return first_corners[polygon + 1] - first_corners[polygon]; }

  /// returns the polygon of a corner.
  Index polygon_of_corner(Index corner) const
  {
    const auto after = std::upper_bound(first_corners.begin(), first_corners.end(), corner);
    return static_cast<Index>(after - first_corners.begin()) - 1;
  }

  /// returns the number of the coordinates of a corner in `texture`, or `none`.
  Index texture_point(Index corner) const
  {
    return has_point_texture ? vertices[corner] : corner_texture.empty() ? none : corner_texture[corner];
  }

  /// returns the number of the material of a polygon in `material_names`, or `none`.
  Index material(Index polygon) const { return materials.empty() ? none : materials[polygon]; }

  /// adds a polygon with corners at points.
  void add_polygon(const std::vector<Index>& corners)
  {
    vertices.insert(vertices.end(), corners.begin(), corners.end());
    first_corners.push_back(static_cast<Index>(vertices.size()));
  }
};

/// \ingroup PkgTextureAtlasRef
///
/// The atlas of a soup: the output of `make_atlas()`.
struct Soup_atlas
{
  /// The coordinates of each corner of the soup; no numbers (NaN) in polygons without chart.
  std::vector<Surface_soup::Kernel::Point_2> uv;
  std::vector<int> charts; ///< The number of the chart of each polygon, from 0 on; -1 without a chart.

  /// Of each polygon: whether the surface has it turned over, so that its corners run clockwise in the plane.
  std::vector<bool> is_turned;

  /// The edges where charts are cut open, each as the numbers of two points, sorted.
  std::vector<std::pair<Surface_soup::Index, Surface_soup::Index>> seams;
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_SURFACE_SOUP_H
