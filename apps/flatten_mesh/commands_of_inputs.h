// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_COMMANDS_OF_INPUTS_H
#define FLATTEN_MESH_COMMANDS_OF_INPUTS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/batch/output_names.h"
#include "flatten_mesh/check_outputs.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <boost/algorithm/string/replace.hpp>

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

// The command for one of the inputs, with the names of its own outputs. If it is the only one, a percent sign behind a
// digit, as in `50% off.glb`, is itself.
inline Command_line command_of_input(Command_line command, const std::string& input)
{
  const bool is_only_one = command.inputs.size() == 1 && command.batch.shard.empty();
  command.input = input;
  command.title = input == standard_input ? "standard input" : in_one_line("'" + input + "'");
  const std::string name = name_for_outputs(command.batch, input);
  boost::replace_all(command.atlas.seams_from, placeholder, name);
  boost::replace_all(command.atlas.bake_from, placeholder, name);
  boost::replace_all(command.texture, placeholder, name);
  for(const internal::Output_option& option : internal::output_options()) {
    std::string& file = command.*option.file;
    for(std::size_t i = file.find(placeholder); i != file.npos; i = file.find(placeholder, i)) {
      const bool is_itself = is_only_one && i > 0 && file[i - 1] >= '0' && file[i - 1] <= '9';
      file.replace(i, 1, is_itself ? placeholder : name);
      i += is_itself ? 1 : name.size();
    }
  }
  return command;
}

// The commands for all inputs, each of which is made when it is asked for: there may be many.
class Commands_of_models
{
public:
  explicit Commands_of_models(Command_line command)
      : m_command(std::move(command)), m_inputs(std::exchange(m_command.inputs, {}))
  {}

  std::size_t size() const { return m_command.input.empty() ? m_inputs.size() : 1; }

  // A command with one input has the names of its outputs already.
  Command_line operator[](const std::size_t i) const
  {
    return m_command.input.empty() ? command_of_input(m_command, m_inputs[i]) : m_command;
  }

private:
  Command_line m_command;
  std::vector<std::string> m_inputs;
};

// One for each input
inline std::vector<Command_line> commands_of_models(const Command_line& command)
{
  const Commands_of_models each(command);
  std::vector<Command_line> commands;
  for(std::size_t i = 0; i < each.size(); ++i) {
    commands.push_back(each[i]);
  }
  return commands;
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
                         (command.batch.shard.empty() ? count_text(command.inputs.size(), "input")
                                                      : "the inputs of several shards") +
                         ": put a '%' into it, which stands for the name of each input, as in '%." +
                         option.formats.front() + "'");
    }
  }
}

} // namespace internal

// Throws unless the outputs of all inputs fit their formats, and lead to different files, none of them an input.
inline void check_outputs_of_inputs(const Command_line& command)
{
  if(command.inputs.size() > 1 || !command.batch.shard.empty()) {
    internal::check_placeholders(command);
  }
  std::map<std::filesystem::path, std::string> inputs, outputs;
  for(const std::string& input : command.inputs) {
    inputs.emplace(resolved(input), input);
  }
  const Commands_of_models commands(command);
  for(std::size_t i = 0; i < commands.size(); ++i) {
    const Command_line each = commands[i];
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
                           ": inputs with the same name need --output-folder, which keeps their folders, or "
                           "runs of their own");
      }
    }
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_COMMANDS_OF_INPUTS_H
