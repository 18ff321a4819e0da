// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_WELDING_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_WELDING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

namespace CGAL::Texture_atlas::internal::prepare {

// Which vertices at the same place are joined
struct Welding
{
  enum Extent
  {
    NONE,
    SEPARATE_FACES, // if no two faces share a vertex
    ALL
  };

  Extent extent = ALL;
  double tolerance = 0; // the distance of points that count as the same
};

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_WELDING_H
