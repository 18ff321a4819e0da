// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SIMPLIFY_INPUT_H
#define FLATTEN_MESH_SIMPLIFY_INPUT_H

#include "flatten_mesh/Notes.h"
#include "flatten_mesh/atlas/Atlas_input.h"

#include <cstddef>

namespace flatten_mesh {

// Simplifies a surface to this many triangles, or as few as keep it valid: the model becomes the simplified surface,
// without what was set aside. Notes say what becomes of it.
void simplify_input(std::size_t triangles, Atlas_input& input, Notes& notes);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SIMPLIFY_INPUT_H
