// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SWEEP_COMMAND_LINE_H
#define SWEEP_COMMAND_LINE_H

#include "../common/Command_options.h"
#include "../common/run_child.h"

#include <stdexcept>
#include <string>

namespace sweep {

using namespace benchmarks;

struct Command_line
{
  std::string folder = ABF_EXAMPLES_DIR;
  std::string method = "direct", output;
  Child_limits limits = {120, 8};
  bool help = false;

  // What a process of its own shall do
  std::string file;
  int first_run = 0;
};

namespace internal {

inline Command_options options_of(Command_line& command)
{
  Command_options options;
  options.add(
      "folder", po::value(&command.folder)->value_name("FOLDER"),
      "with meshes, also in folders within it; the word '--folder' may be left out. By default the data of "
      "the examples");
  options.may_be_left_out("folder", 1);
  options.add("method", value_with_default(command.method, "METHOD"), "direct or hierarchical");
  options.add_limits(command.limits);
  options.add_output_and_help(command.output, command.help);
  options.add_hidden("file", po::value(&command.file));
  options.add_hidden("first-run", po::value(&command.first_run));
  return options;
}

} // namespace internal

// Throws an exception for wrong usage.
inline Command_line parse_command_line(const int argc, char* argv[])
{
  Command_line command;
  internal::options_of(command).parse(argc, argv);
  if(command.method != "direct" && command.method != "hierarchical") {
    throw std::runtime_error("--method is direct or hierarchical");
  }
  require_positive("--timeout and --memory", command.limits.seconds, command.limits.gigabytes);
  return command;
}

inline std::string help_text()
{
  Command_line command;
  return internal::options_of(command).help_text(
      "sweep: flattens every component with a border of every mesh in a folder.\n\n"
      "The exit status is 0 only if there was no crash, no timeout, and no map that was called valid and "
      "is not.\n\n"
      "usage: sweep [FOLDER] [options]");
}

} // namespace sweep

#endif // SWEEP_COMMAND_LINE_H
