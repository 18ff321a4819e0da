// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECK_STYLE_OPTIONS_H
#define FLATTEN_MESH_CHECK_STYLE_OPTIONS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/model/Model_style.h"
#include "flatten_mesh/texts.h"
#include "flatten_mesh/texture_option.h"

#include <string>

namespace flatten_mesh {

namespace internal {

// Throws unless the output has the format that an option is for.
inline void check_format_for(const bool is_given, const bool is_right, const std::string& option,
                             const std::string& rest)
{
  if(is_given && !is_right) {
    throw Usage_error("--" + option + " needs " + rest);
  }
}

// GLB files contain their pictures, and standard output has no place beside it.
inline void check_texture(const Command_line& command, const std::string& format)
{
  if(command.texture.empty()) {
    return;
  }
  check_format_for(true,
                   !command.output.empty() && format != "glb" && command.output != standard_output &&
                       !is_other_file(resolved(command.output)),
                   "texture", "--output NAME.obj or NAME.ply, which name a picture beside them");
  if(!command.atlas.bake_from.empty()) {
    throw Usage_error("--texture and --bake-from exclude each other: the output names the baked pictures");
  }
  if(command.atlas.uv_set == 1) {
    throw Usage_error("--texture and --uv-set 1 exclude each other: pictures take the first coordinates");
  }
  if(format == "ply" && command.texture.find(udim_placeholder) != command.texture.npos) {
    throw Usage_error("--texture with " + std::string(udim_placeholder) +
                      " needs --output NAME.obj: PLY files name one picture for all pages");
  }
#ifndef ABF_WITH_PNG
  if(makes_checkerboard(command)) {
    throw Usage_error("this program was built without libpng, which --texture checkerboard needs: install "
                      "libpng-dev and build it again, or name a picture");
  }
#endif
}

// What only one format has goes with no other one.
inline void check_style_options(const Command_line& command)
{
  const std::string format = file_format(command.output);
  const bool has_output = !command.output.empty(), has_vertices = command.ply_coordinates == "vertex";
  check_format_for(command.triangles, has_output && format != "glb", "triangles",
                   "--output NAME.obj or NAME.ply: GLB files always have triangles");
  check_format_for(has_vertices, format == "ply", "ply-coordinates vertex", "--output NAME.ply");
  check_format_for(command.has_placeholder_texture, format == "glb", "placeholder-texture",
                   "--output NAME.glb");
  check_texture(command, format);
  if(has_vertices && command.atlas.uv_set == 1) {
    throw Usage_error("--ply-coordinates vertex and --uv-set 1 exclude each other: vertices have one set");
  }
  if(command.has_placeholder_texture && !command.atlas.bake_from.empty()) {
    throw Usage_error(
        "--placeholder-texture and --bake-from exclude each other: the baked pictures keep the coordinates");
  }
}

} // namespace internal

// What the output is to be like
inline Model_style style_of(const Command_line& command)
{
  return {texture_name(command), command.ply_coordinates == "vertex", command.has_placeholder_texture};
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECK_STYLE_OPTIONS_H
