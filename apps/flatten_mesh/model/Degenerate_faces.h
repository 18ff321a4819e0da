// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DEGENERATE_FACES_H
#define FLATTEN_MESH_DEGENERATE_FACES_H

namespace flatten_mesh {

// What happens to degenerate faces, such as faces with two corners or with equal corners, and to coordinates that are
// not finite.
enum class Degenerate_faces
{
  REFUSED,
  KEPT
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DEGENERATE_FACES_H
