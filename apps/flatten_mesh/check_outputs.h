// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECK_OUTPUTS_H
#define FLATTEN_MESH_CHECK_OUTPUTS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/bake/baked_files.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"
#include "flatten_mesh/texture_option.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// An option that names an output.
struct Output_option
{
  std::string name;
  std::string Command_line::*file;
  std::vector<std::string> formats; // the extensions
};

inline const std::array<Output_option, 7>& output_options()
{
  static const std::array<Output_option, 7> options = {
      {{"output", &Command_line::output, {"obj", "ply", "glb"}},
       {"svg", &Command_line::svg, {"svg"}},
       {"picture", &Command_line::picture, {"png"}},
       {"report", &Command_line::report, {"html"}},
       {"chart-image", &Command_line::chart_image, {"png"}},
       {"seams-to", &Command_line::seams_to, {"txt"}},
       {"json", &Command_line::json, {"json"}}}};
  return options;
}

// Extensions of other formats are refused, because they would mislead.
inline void check_extension(const Output_option& option, const std::string& file)
{
  const std::string format = file_format(file);
  if(is_other_file(resolved(file))) {
    return;
  }
  if(!format.empty() &&
     std::find(option.formats.begin(), option.formats.end(), format) == option.formats.end()) {
    std::string known;
    for(const Output_option& other : output_options()) {
      known +=
          (known.empty() ? "--" : ", --") + other.name + " ." + boost::algorithm::join(other.formats, "|.");
    }
    throw Output_error("cannot write '" + file + "': --" + option.name + " does not write ." + format +
                       "; the formats are " + known);
  }
#ifndef ABF_WITH_GLTF
  if(format == "glb") {
    throw Output_error(
        "cannot write '" + file +
        "': this program was built without tinygltf, which .glb needs: install libtinygltf-dev "
        "and build it again, or use .obj or .ply");
  }
#endif
}

inline void check_different(const Output_option& option, const Output_option& other, const std::string& file,
                            const std::string& other_file)
{
  if(other_file.empty() || !is_same_file(file, other_file) || is_other_file(resolved(file))) {
    return;
  }
  throw Output_error("--" + other.name + " '" + other_file + "' and --" + option.name + " '" + file +
                     "' are the same " + (file == standard_output ? "output" : "file") +
                     ": choose different names");
}

inline void check_output(const Command_line& command, const Output_option& option)
{
  const std::string& file = command.*option.file;
  if(file.empty()) {
    return;
  }
  check_extension(option, file);
  const auto is_read = [&file](const std::string& input) {
    return !input.empty() && input != standard_input && is_same_file(input, file);
  };
  if(file != standard_output &&
     (is_read(command.input) || is_read(command.border_angles) ||
      (is_selection_file(command.cut) && is_read(command.cut)) ||
      (is_selection_file(command.atlas.seams_from) && is_read(command.atlas.seams_from)))) {
    throw Output_error("'" + file + "' would overwrite the input: choose another name");
  }
  for(const Output_option& other : output_options()) {
    if(other.name != option.name) {
      check_different(option, other, file, command.*other.file);
    }
  }
}

// The files that are written beside the model, and the file that is baked
inline void check_baking_files(const Command_line& command)
{
  if(command.atlas.bake_from.empty()) {
    return;
  }
  if(command.output.empty() || command.output == standard_output || is_other_file(resolved(command.output)) ||
     file_format(command.output) == "ply") {
    throw Output_error("--bake-from needs --output NAME.obj or NAME.glb, which have a place for pictures");
  }
  std::vector<std::string> written = baked_files(command);
  for(const std::string& file : written) {
    if(is_same_file(file, command.input)) {
      throw Output_error("'" + file + "' would overwrite the input: choose another name");
    }
    for(const Output_option& option : output_options()) {
      if(!(command.*option.file).empty()) {
        check_different(option, {"bake-from", nullptr, {}}, command.*option.file, file);
      }
    }
  }
  for(const Output_option& option : output_options()) {
    written.push_back(command.*option.file);
  }
  for(const std::string& file : written) {
    if(!file.empty() && file != standard_output && is_same_file(file, command.atlas.bake_from)) {
      throw Output_error("'" + file + "' would overwrite the surface that is baked: choose another name");
    }
  }
}

// What `--texture` writes overwrites nothing, and no output overwrites the picture, except the image of charts.
inline void check_texture_files(const Command_line& command)
{
  if(command.texture.empty() || command.output.empty()) {
    return;
  }
  const std::vector<std::string> written = files_of_texture(command);
  for(const std::string& file : written) {
    if(is_same_file(file, command.input)) {
      throw Output_error("'" + file + "' would overwrite the input: choose another name");
    }
  }
  for(const Output_option& option : output_options()) {
    const std::string& file = command.*option.file;
    for(const std::string& other : written) {
      if(!file.empty()) {
        check_different(option, {"texture", nullptr, {}}, file, other);
      }
    }
    if(!file.empty() && option.name != "chart-image") {
      check_different(option, {"texture", nullptr, {}}, file, texture_file(command));
    }
  }
}

} // namespace internal

// Throws unless the names of the outputs fit their formats and lead to different files.
inline void check_outputs(const Command_line& command)
{
  for(const internal::Output_option& option : internal::output_options()) {
    internal::check_output(command, option);
  }
  internal::check_baking_files(command);
  internal::check_texture_files(command);
}

inline bool takes_standard_output(const Command_line& command)
{
  const auto& options = internal::output_options();
  return std::any_of(options.begin(), options.end(), [&command](const internal::Output_option& option) {
    return command.*option.file == standard_output;
  });
}

// Whether the name of the report for programs is valid, so that the report can tell what else is wrong.
inline bool can_write_json(const Command_line& command)
{
  if(command.input.empty() && has_placeholder(command.json)) {
    return false;
  }
  try {
    internal::check_output(command, internal::output_options().back());
    return !command.json.empty();
  } catch(const Output_error&) {
    return false;
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECK_OUTPUTS_H
