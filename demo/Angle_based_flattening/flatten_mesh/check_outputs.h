// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECK_OUTPUTS_H
#define FLATTEN_MESH_CHECK_OUTPUTS_H

#include "Command_line.h"
#include "file_names.h"
#include "texts.h"

#include <algorithm>
#include <array>
#include <string>

namespace flatten_mesh {

namespace internal {

// An option that names an output.
struct Output_option
{
  std::string name;
  std::string Command_line::*file;
  std::string format; // the extension
};

inline const std::array<Output_option, 5>& output_options()
{
  static const std::array<Output_option, 5> options = {{{"output", &Command_line::output, "obj"},
                                                        {"svg", &Command_line::svg, "svg"},
                                                        {"picture", &Command_line::picture, "png"},
                                                        {"seams", &Command_line::seams, "txt"},
                                                        {"json", &Command_line::json, "json"}}};
  return options;
}

// The name of a file does not determine its format. Extensions of other formats are refused, because they would
// mislead.
inline void check_extension(const Output_option& option, const std::string& file)
{
  const std::string format = file_format(file);
  if(!format.empty() && format != option.format && !is_other_file(resolved(file))) {
    std::string known;
    for(const Output_option& other : output_options()) {
      known += (known.empty() ? "--" : ", --") + other.name + " ." + other.format;
    }
    throw Output_error("cannot write '" + file + "': --" + option.name + " does not write ." + format +
                       "; the formats are " + known);
  }
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
  if(file != standard_output && (is_same_file(command.input, file) ||
                                 (is_selection_file(command.cut) && is_same_file(command.cut, file)))) {
    throw Output_error("'" + file + "' would overwrite the input: choose another name");
  }
  for(const Output_option& other : output_options()) {
    if(other.name != option.name) {
      check_different(option, other, file, command.*other.file);
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
  try {
    internal::check_output(command, internal::output_options().back());
    return !command.json.empty();
  } catch(const Output_error&) {
    return false;
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECK_OUTPUTS_H
