// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_COMMANDS_OF_INPUTS_H
#define FLATTEN_MESH_COMMANDS_OF_INPUTS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/check_outputs.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <boost/algorithm/string/replace.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace flatten_mesh {

// The command for one of several inputs, with the names of its own outputs.
inline Command_line command_of_input(Command_line command, const std::string& input)
{
  const bool is_stream = input == standard_input;
  command.input = input;
  command.title = is_stream ? "standard input" : in_one_line("'" + input + "'");
  const std::string stem = is_stream ? "stdin" : std::filesystem::path(input).stem().string();
  boost::replace_all(command.atlas.seams_from, placeholder, stem);
  boost::replace_all(command.atlas.bake_from, placeholder, stem);
  for(const internal::Output_option& option : internal::output_options()) {
    boost::replace_all(command.*option.file, placeholder, stem);
  }
  return command;
}

// One for each input. A command with one input has the names of its outputs already.
inline std::vector<Command_line> commands_of_models(const Command_line& command)
{
  if(!command.input.empty()) {
    return {command};
  }
  std::vector<Command_line> commands;
  for(const std::string& input : command.inputs) {
    commands.push_back(command_of_input(command, input));
  }
  return commands;
}

// One for each run. Inputs that share an atlas have one.
inline std::vector<Command_line> commands_of_inputs(const Command_line& command)
{
  return command.atlas.is_shared ? std::vector<Command_line>{command} : commands_of_models(command);
}

namespace internal {

// Whether an output is written once for all models that share an atlas
inline bool is_of_whole_atlas(const Command_line& command, const Output_option& option)
{
  return command.atlas.is_shared && option.name != "output" && option.name != "seams-to";
}

inline void check_placeholders(const Command_line& command)
{
  for(const Output_option& option : output_options()) {
    const std::string& file = command.*option.file;
    if(!file.empty() && !has_placeholder(file) && !is_other_file(resolved(file)) &&
       !is_of_whole_atlas(command, option)) {
      throw Output_error("--" + option.name + " '" + file + "' names one file for " +
                         count_text(command.inputs.size(), "input") +
                         ": put a '%' into it, which stands for the name of each input, as in '%." +
                         option.formats.front() + "'");
    }
  }
}

} // namespace internal

// Throws unless the outputs of all inputs fit their formats, and lead to different files, none of them an input.
inline void check_outputs_of_inputs(const Command_line& command)
{
  if(command.inputs.size() > 1) {
    internal::check_placeholders(command);
  }
  std::map<std::filesystem::path, std::string> inputs, outputs;
  for(const std::string& input : command.inputs) {
    inputs.emplace(resolved(input), input);
  }
  for(const Command_line& each : commands_of_models(command)) {
    check_outputs(each);
    for(const internal::Output_option& option : internal::output_options()) {
      const std::string& file = each.*option.file;
      if(file.empty() || command.inputs.size() == 1 || is_other_file(resolved(file))) {
        continue;
      }
      if(inputs.count(resolved(file)) != 0) {
        throw Output_error("'" + file + "' would overwrite the input: choose another name");
      }
      if(internal::is_of_whole_atlas(command, option)) {
        continue;
      }
      if(const auto [other, is_new] = outputs.emplace(resolved(file), each.title); !is_new) {
        throw Output_error("'" + file + "' would be written for " + other->second + " and for " + each.title +
                           ": inputs with the same name need runs of their own");
      }
    }
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_COMMANDS_OF_INPUTS_H
