// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_COMMAND_LINE_H
#define SOLVERS_COMMAND_LINE_H

#include "../common/Command_options.h"
#include "../common/number_list.h"
#include "../common/run_child.h"

#include <cstddef>
#include <string>
#include <vector>

namespace solvers {

using namespace benchmarks;

struct Command_line
{
  std::string mesh = ABF_EXAMPLES_DIR "/shell.off";
  std::string sizes = "20000,100000,400000,1500000";
  std::string output;
  int repeat = 3;
  Child_limits limits = {600, 16};
  bool help = false;

  std::string measure, matrix; // what a process that measures shall do

  std::vector<std::size_t> triangles() const { return triangles_of_list(sizes, "--sizes"); }
};

namespace internal {

inline Command_options options_of(Command_line& command)
{
  Command_options options;
  options.add_base_mesh(command.mesh);
  options.add("sizes", value_with_default(command.sizes, "N,N,..."), "numbers of triangles");
  options.add_repeat(command.repeat);
  options.add_limits(command.limits);
  options.add_output_and_help(command.output, command.help);
  options.add_hidden("measure", po::value(&command.measure));
  options.add_hidden("matrix", po::value(&command.matrix));
  return options;
}

} // namespace internal

// Throws an exception for wrong usage.
inline Command_line parse_command_line(const int argc, char* argv[])
{
  Command_line command;
  internal::options_of(command).parse(argc, argv);
  require_positive("--repeat, --timeout and --memory", command.repeat, command.limits.seconds,
                   command.limits.gigabytes);
  return command;
}

inline std::string help_text()
{
  Command_line command;
  return internal::options_of(command).help_text(
      "solvers: compares sparse direct solvers on the matrices of ABF++.\n\n"
      "usage: solvers [FILE] [options]");
}

} // namespace solvers

#endif // SOLVERS_COMMAND_LINE_H
