// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECK_UV_SET_H
#define FLATTEN_MESH_CHECK_UV_SET_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/texts.h"

#include <string>

namespace flatten_mesh {

namespace internal {

inline void check_uv_set(const Command_line& command)
{
  const Atlas_command& atlas = command.atlas;
  if(atlas.uv_set == 0) {
    return;
  }
  if(command.output.empty() || is_obj_output(command.output)) {
    throw Usage_error(
        "--uv-set 1 needs --output NAME.glb or NAME.ply: OBJ files have one set of texture coordinates");
  }
  if(atlas.simplified_triangles > 0 || !atlas.bake_from.empty()) {
    throw Usage_error(
        "--uv-set 1 goes without --simplify and --bake-from: a simplified surface has no texture "
        "coordinates of its own, and baked textures take the first ones");
  }
}

} // namespace internal

// Throws an `Input_error` if there are no coordinates that could be the first ones.
inline void check_first_set(const Command_line& command, const Model& model)
{
  if(command.atlas.uv_set == 1 && model.texture.empty()) {
    throw Input_error("'" + model.name +
                      "': --uv-set 1 keeps the texture coordinates of the input as the first ones, but "
                      "it has none: leave the option out");
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECK_UV_SET_H
