// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BAKED_FILES_H
#define FLATTEN_MESH_BAKED_FILES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/file_names.h"

#include <filesystem>
#include <string>
#include <vector>

namespace flatten_mesh {

// A file that is written beside the model: its name without extension is followed by `ending`.
inline std::string baked_file(const Command_line& command, const std::string& ending)
{
  std::filesystem::path path(command.output);
  path.replace_extension();
  return path.string() + ending;
}

constexpr const char* material_ending = ".mtl";
constexpr const char* normals_ending = "_normals.png";
constexpr const char* displacement_ending = "_displacement.png";
constexpr const char* colors_ending = "_colors.png";

// All that baking may write beside the model. A GLB file contains its pictures.
inline std::vector<std::string> baked_files(const Command_line& command)
{
  std::vector<std::string> names;
  if(!command.atlas.bake_from.empty() && is_obj_output(command.output)) {
    for(const char* ending : {material_ending, normals_ending, displacement_ending, colors_ending}) {
      names.push_back(baked_file(command, ending));
    }
  }
  return names;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BAKED_FILES_H
