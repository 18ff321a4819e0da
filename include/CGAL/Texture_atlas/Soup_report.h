// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SOUP_REPORT_H
#define CGAL_TEXTURE_ATLAS_SOUP_REPORT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/Symmetry_report.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// \file Soup_report.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// The report of `make_atlas()` and `make_common_atlas()` for points and polygons.
///
/// `Atlas_report::skipped` has all polygons without chart, also those that cannot be part of a surface. Its
/// `first_face` is the number of a polygon, and its `number_of_faces` counts polygons.
struct Soup_report : Atlas_report
{
  using Atlas_report::Atlas_report;

  /// Whether seams could be made symmetric.
  struct Symmetry
  {
    Mirror_plane_report plane;          ///< The best plane.
    bool has_symmetric_surface = false; ///< Whether the surface is symmetric.
    bool has_symmetric_seams = false;   ///< Whether the seams are.
    double asymmetry = 0;               ///< See `Symmetry_report::asymmetry`.
    double extra_length = 0; ///< Of the seams, as a share of the length of seams that need not be symmetric.
  };

  /// How seams were chosen.
  struct Seams
  {
    /// `"length"`, `"near-creases"`, `"creases"`, `"hidden"`; `"given"` if charts were given, `"various"` for surfaces
    /// that differ.
    std::string name = "length";
    std::optional<double> crease_angle;  ///< If creases are seams: the least angle of a crease, in radians.
    bool lacks_creases = false;          ///< Whether creases were asked for, and there is none.
    std::optional<bool> is_hard_surface; ///< If it was looked at: see `Crease_report::is_hard_surface()`.
    std::optional<Symmetry> symmetry;    ///< If it was asked for.
    std::size_t turned_charts =
        0; ///< The number of given charts that were mirrored, and therefore turned over.
    std::size_t mirror_edges =
        0; ///< The number of new seam edges, along which given coordinates are mirrored.
  };

  Seams seams;                          ///< How seams were chosen.
  std::size_t number_of_vertices = 0;   ///< The number of vertices of the surface, after repairs.
  std::size_t number_of_triangles = 0;  ///< The number of triangles of the surface.
  std::size_t number_of_components = 0; ///< The number of components of the surface.
  std::size_t number_of_ignored =
      0; ///< The number of polygons that were ignored: see `Surface_soup::is_ignored`.

  /// What happened to the polygons, and what was not reached, in sentences that count polygons and points from 1.
  std::vector<std::string> notes;

  std::vector<std::size_t> offending_points;   ///< The points of the soup that the diagnosis is about.
  std::vector<std::size_t> offending_polygons; ///< The polygons of the soup that it is about.
  std::size_t offending_soup = 0;              ///< The number of the soup that these belong to.
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_SOUP_REPORT_H
