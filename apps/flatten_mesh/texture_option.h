// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXTURE_OPTION_H
#define FLATTEN_MESH_TEXTURE_OPTION_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/bake/baked_files.h"
#include "flatten_mesh/file_names.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

constexpr const char* checkerboard = "checkerboard"; // in place of the name of a picture
constexpr const char* checkerboard_ending = "_checkerboard.png";
constexpr const char* textured_material = "textured";

inline bool makes_checkerboard(const Command_line& command)
{
  return command.texture == checkerboard;
}

// The picture that `--texture` asks for, or an empty name
inline std::string texture_file(const Command_line& command)
{
  return makes_checkerboard(command) ? baked_file(command, checkerboard_ending) : command.texture;
}

// The same, as seen from the folder of the output
inline std::string texture_name(const Command_line& command)
{
  if(command.texture.empty()) {
    return "";
  }
  std::error_code ignored;
  const std::filesystem::path file = texture_file(command);
  const std::filesystem::path name = std::filesystem::proximate(
      std::filesystem::absolute(file), std::filesystem::absolute(command.output).parent_path(), ignored);
  return (name.empty() ? file : name).generic_string();
}

// Whether nothing is at the place of the picture, and nothing will be written there
inline bool lacks_picture(const Command_line& command)
{
  std::error_code ignored;
  return !command.texture.empty() && !makes_checkerboard(command) &&
         command.texture.find(udim_placeholder) == command.texture.npos &&
         !std::filesystem::exists(command.texture, ignored) &&
         (command.chart_image.empty() || !is_same_file(command.texture, command.chart_image));
}

// What `--texture` writes beside the output
inline std::vector<std::string> files_of_texture(const Command_line& command)
{
  std::vector<std::string> names;
  if(!command.texture.empty() && is_obj_output(command.output)) {
    names.push_back(baked_file(command, material_ending));
  }
  if(makes_checkerboard(command)) {
    names.push_back(texture_file(command));
  }
  return names;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TEXTURE_OPTION_H
