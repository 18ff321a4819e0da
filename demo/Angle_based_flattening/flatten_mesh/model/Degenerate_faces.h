// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_DEGENERATE_FACES_H
#define FLATTEN_MESH_DEGENERATE_FACES_H

namespace flatten_mesh {

// What is done about faces that are none, such as those with two corners or with a corner twice, and about coordinates
// that are no finite numbers.
enum class Degenerate_faces
{
  REFUSED,
  KEPT
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_DEGENERATE_FACES_H
