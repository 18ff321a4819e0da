// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WELDING_H
#define FLATTEN_MESH_WELDING_H

namespace flatten_mesh {

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

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WELDING_H
