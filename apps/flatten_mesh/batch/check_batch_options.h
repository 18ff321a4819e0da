// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECK_BATCH_OPTIONS_H
#define FLATTEN_MESH_CHECK_BATCH_OPTIONS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/batch/Child_processes.h"
#include "flatten_mesh/batch/input_list.h"
#include "flatten_mesh/batch/output_names.h"
#include "flatten_mesh/check_outputs.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/process_memory.h"
#include "flatten_mesh/texts.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

namespace flatten_mesh {

namespace internal {

// A number of bytes, with a suffix K, M or G for powers of 1024
inline std::size_t bytes_of(const std::string& text)
{
  const std::string suffixes = "KMG";
  const char* const end = text.data() + text.size();
  double bytes = 0;
  auto [place, error] = std::from_chars(text.data(), end, bytes);
  if(error == std::errc() && place != end) {
    const std::size_t power = suffixes.find(*place);
    if(power != std::string::npos) {
      bytes *= static_cast<double>(std::size_t(1) << 10 * (power + 1));
      ++place;
    }
  }
  if(error != std::errc() || place != end || !(bytes >= 1) || bytes > 1e18) {
    throw Usage_error("--memory takes a number of bytes, as in 500M or 4G, not '" + text + "'");
  }
  return static_cast<std::size_t>(bytes);
}

// The program is as large before it reads a model.
inline void check_memory(const Batch_options& batch)
{
  const double own = resident_memory_mb("VmRSS");
  if(own == 0) {
    throw Usage_error("--memory reads in /proc what a process holds, and this system has no such folder");
  }
  if(static_cast<double>(batch.memory_bytes) < own * (1 << 20)) {
    throw Usage_error("--memory " + batch.memory + " is less than the program itself takes, " +
                      format_number("%.0fM", std::ceil(own)));
  }
}

inline void check_batch_numbers(Batch_options& batch)
{
  batch.memory_bytes = batch.memory.empty() ? 0 : bytes_of(batch.memory);
  if(batch.memory_bytes > 0) {
    check_memory(batch);
  }
}

inline void check_summary(const boost::program_options::variables_map& values, const Command_line& command)
{
  for(const auto& [option, value] : values) {
    if(!value.defaulted() && option != "summary" && option != "output" && option != "report" &&
       option != "quiet") {
      throw Usage_error("--summary reads reports and flattens nothing: it goes without --" + option);
    }
  }
  if(!command.output.empty() && command.output != standard_output && file_format(command.output) != "csv") {
    throw Usage_error("--summary writes a table: give --output a name that ends with .csv, not '" +
                      command.output + "'");
  }
  for(const Output_option& option : output_options()) {
    if(option.file == &Command_line::report) {
      check_output(command, option);
    }
  }
}

// The outputs of other shards are not looked at one by one.
inline void check_names_of_outputs(const Command_line& command)
{
  const auto& options = output_options();
  if(std::none_of(options.begin(), options.end(), [&command](const Output_option& option) {
       return has_placeholder(command.*option.file);
     })) {
    return;
  }
  std::unordered_map<std::string, std::string> inputs;
  for(const std::string& input : command.inputs) {
    const auto [other, is_new] = inputs.emplace(name_for_outputs(command.batch, input), input);
    if(!is_new) {
      throw Output_error("'" + other->second + "' and '" + input +
                         "' would have outputs of the same name: " + "--output-folder keeps their folders");
    }
  }
}

// Leaves the inputs of other shards out.
inline void choose_shard(Command_line& command)
{
  if(command.batch.shard.empty()) {
    return;
  }
  if(command.atlas.is_shared) {
    throw Usage_error("--one-atlas goes without --shard: all inputs share the atlas");
  }
  const Shard shard = shard_of(command.batch.shard);
  if(command.inputs.empty()) {
    throw Usage_error("no input: --shard chooses among the files that are named, or that are in --list");
  }
  check_names_of_outputs(command);
  command.inputs = inputs_of_shard(command.inputs, shard);
}

// Takes the names in the list to the inputs, and puts the outputs into their folder.
inline void gather_inputs(Command_line& command)
{
  Batch_options& batch = command.batch;
  if(batch.is_null_separated && batch.list.empty()) {
    throw Usage_error("--null goes with --list only: it says how names are separated there");
  }
  if(batch.resumes && command.json.empty()) {
    throw Usage_error("--resume needs --json: the reports say what is done");
  }
  if(!batch.list.empty()) {
    const std::vector<std::string> names = names_in_list(batch.list, batch.is_null_separated);
    command.inputs.insert(command.inputs.end(), names.begin(), names.end());
  }
  if(!batch.output_folder.empty()) {
    batch.common_folder = common_folder(command.inputs);
    for(const Output_option& option : output_options()) {
      command.*option.file = in_output_folder(batch, command.*option.file);
    }
  }
  choose_shard(command);
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECK_BATCH_OPTIONS_H
