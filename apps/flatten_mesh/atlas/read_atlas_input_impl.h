// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_ATLAS_INPUT_IMPL_H
#define FLATTEN_MESH_READ_ATLAS_INPUT_IMPL_H

#include "flatten_mesh/compiled.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/check_uv_set.h"
#include "flatten_mesh/face_options.h"
#include "flatten_mesh/model/read_model.h"
#include "flatten_mesh/weld_option.h"

#include <utility>

namespace flatten_mesh {

FLATTEN_MESH_INLINE Atlas_input read_atlas_input(const Command_line& command, Notes& notes)
{
  Model model =
      read_model(command.input, Degenerate_faces::KEPT, notes, command.format, gltf_options_of(command));
  check_first_set(command, model);
  try {
    return atlas_input_of(std::move(model), command.repair == "on", notes, welding_of(command),
                          face_choice_of(command.atlas));
  } catch(const Input_error& error) {
    throw Input_error(command.title + ": " + error.what());
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_ATLAS_INPUT_IMPL_H
