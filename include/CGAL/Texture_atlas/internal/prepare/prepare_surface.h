// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_SURFACE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_SURFACE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// How a surface is made of polygons
struct Preparation
{
  bool repair = true; // orients and separates polygons that do not fit together
  Welding welding;
  std::vector<bool> is_left_out; // of each polygon: it is not to be flattened. Empty if all are
};

struct Prepared_surface
{
  Mesh mesh; // without what is set aside; empty if nothing remains
  Corner_origins origins;
  std::vector<Skipped_part> set_aside; // what cannot be part of a surface, and why
  std::size_t left_out = 0;            // the number of polygons that are not to be flattened
};

// The surface of the polygons: welded, oriented, separated where it is not a manifold, and triangulated, without what
// cannot be part of it. Throws an `Input_error` if the polygons are wrong as a whole.
Prepared_surface prepare_surface(const Surface_soup& given, const Preparation& how, Notes& notes);

} // namespace CGAL::Texture_atlas::internal::prepare

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/prepare/prepare_surface_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_PREPARE_SURFACE_H
