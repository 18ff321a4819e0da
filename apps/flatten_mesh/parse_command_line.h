// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PARSE_COMMAND_LINE_H
#define FLATTEN_MESH_PARSE_COMMAND_LINE_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/batch/check_batch_options.h"
#include "flatten_mesh/batch/recorded_options.h"
#include "flatten_mesh/check_one_atlas.h"
#include "flatten_mesh/check_options.h"
#include "flatten_mesh/check_style_options.h"
#include "flatten_mesh/check_uv_set.h"
#include "flatten_mesh/describe_options.h"
#include "flatten_mesh/face_options.h"
#include "flatten_mesh/texts.h"

#include <boost/program_options.hpp>

#include <string>

namespace flatten_mesh {

namespace internal {

inline Values values_of(const int argc, const char* const argv[], const Option_table& table,
                        Command_line& command)
{
  namespace style = po::command_line_style;
  const po::options_description options = table.description();
  po::positional_options_description positional;
  positional.add("input", -1);
  po::variables_map values;
  const po::parsed_options parsed = po::command_line_parser(argc, argv)
                                        .options(options)
                                        .positional(positional)
                                        .style(style::unix_style & ~style::allow_guessing)
                                        .run();
  po::store(parsed, values);
  command.batch.recorded = recorded_options(parsed, table);
  po::notify(values);
  return values;
}

// The report for programs is written even if the rest of the command line is wrong.
inline void find_json(const int argc, const char* const argv[], Command_line& command)
{
  for(int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if(word == "--json" && i + 1 < argc) {
      command.json = argv[i + 1];
    } else if(word.compare(0, 7, "--json=") == 0) {
      command.json = word.substr(7);
    }
  }
}

} // namespace internal

// Throws a `Usage_error` for wrong usage. `command` contains what was understood until then.
inline void parse_command_line(const int argc, const char* const argv[], Command_line& command)
{
  const internal::Option_table table = internal::all_options(command);
  internal::Values values;
  try {
    values = internal::values_of(argc, argv, table, command);
  } catch(const boost::program_options::error& error) {
    internal::find_json(argc, argv, command);
    throw Usage_error(std::string(error.what()) + "; see --help");
  }
  if(command.help || command.version) {
    return;
  }
  command.asks_for_component = internal::is_given(values, "component");
  internal::check_names_of_files(values, command);
  if(!command.batch.summary.empty()) {
    internal::check_summary(values, command);
    return;
  }
  internal::gather_inputs(command);
  internal::check_one_atlas(values, command);
  internal::check_files(command);
  command.atlas.set_defaults();
  table.take(values);
  internal::check_batch_numbers(command.batch);
  internal::check_kind(values, command);
  internal::check_up(values, command);
  internal::check_weld(values, command);
  if(command.verbose && command.quiet) {
    throw Usage_error("--verbose and --quiet exclude each other");
  }
  internal::check_atlas(values, command);
  internal::check_face_choice(values, command.atlas);
  internal::check_uv_set(command);
  internal::check_style_options(command);
  internal::check_plain(values, command);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PARSE_COMMAND_LINE_H
