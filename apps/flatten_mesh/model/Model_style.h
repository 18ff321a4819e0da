// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_MODEL_STYLE_H
#define FLATTEN_MESH_MODEL_STYLE_H

#include <string>

namespace flatten_mesh {

// What formats leave open
struct Model_style
{
  std::string texture;             // PLY: the picture, as the file names it, or empty
  bool has_uv_at_vertices = false; // PLY: texture coordinates belong to vertices, and not to corners of faces
  bool has_tiny_picture = false;   // GLB: the texture coordinates have a picture, which shows nothing
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_MODEL_STYLE_H
