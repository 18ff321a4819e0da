// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_SOUP_OPTIONS_H
#define CGAL_TEXTURE_ATLAS_SOUP_OPTIONS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/Crease_report.h>

#include <cstddef>
#include <optional>

/// \file Soup_options.h

namespace CGAL {

namespace Texture_atlas {

/// \ingroup PkgTextureAtlasRef
///
/// Options of `make_atlas()` for points and polygons: those for meshes, and how a surface is made of the polygons.
struct Soup_options : Atlas_options
{
  /// Where seams run.
  enum Seams
  {
    AUTO, ///< Along creases of surfaces that unfold well there, near creases of others with hard edges, or short.
    LENGTH,       ///< Seams are short.
    NEAR_CREASES, ///< Seams are short, and rather along creases: see `compute_crease_weights()`.
    CREASES,      ///< Creases are seams: see `select_crease_seams()`.
    HIDDEN        ///< Seams are short, and rather where little is seen: see `compute_visibility_weights()`.
  };

  Seams seams = AUTO; ///< Where seams run. Charts that are kept or repaired have their seams already.

  /// With `CREASES`: the least angle of a crease, in radians, above 0 and below \f$\pi\f$.
  double crease_angle = Crease_options().angle;

  /// Whether seams are symmetric, where the surface is and that makes them at most 5 % longer. For one soup.
  bool symmetric = false;

  bool texture_seams = false;  ///< Whether edges where given coordinates differ are seams.
  bool material_seams = false; ///< Whether edges where materials differ are seams.

  /// Whether vertices at the same place are joined where that gives a surface.
  bool weld = true;
  double weld_tolerance =
      0; ///< The distance of points that count as the same place; it needs `weld` and `repair`.

  /// Whether polygons that do not form a manifold are separated, turned or left out. Otherwise, all polygons that hang
  /// together with such ones are left out, and nothing is joined.
  bool repair = true;

  /// The only component that gets charts, numbered by falling number of triangles. For one soup.
  std::optional<std::size_t> component;

  /// sets the options for a purpose, as `Atlas_options` does. `seams` is `LENGTH` unless the purpose is `TEXTURE`.
  Soup_options(Purpose purpose = TEXTURE) : Atlas_options(purpose), seams(purpose == TEXTURE ? AUTO : LENGTH)
  {}
};

} // namespace Texture_atlas

} // namespace CGAL

#endif // CGAL_TEXTURE_ATLAS_SOUP_OPTIONS_H
