// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SWEEP_COMMAND_LINE_H
#define SWEEP_COMMAND_LINE_H

#include "../common/run_child.h"

#include <boost/program_options.hpp>

#include <sstream>
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

namespace po = boost::program_options;

inline po::options_description visible_options(Command_line& command)
{
  po::options_description options("Options", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("folder", po::value(&command.folder)->value_name("FOLDER"),
      "with meshes, also in folders within it; the word '--folder' may be left out. By default the data of "
      "the "
      "examples");
  add("method", po::value(&command.method)->value_name("METHOD")->default_value(command.method),
      "direct or hierarchical");
  add("timeout",
      po::value(&command.limits.seconds)->value_name("SECONDS")->default_value(command.limits.seconds),
      "limit of a process; it is killed then");
  add("memory",
      po::value(&command.limits.gigabytes)->value_name("GB")->default_value(command.limits.gigabytes),
      "limit of a process");
  add("output,o", po::value(&command.output)->value_name("FILE.md"), "write the report there as well");
  add("help,h", po::bool_switch(&command.help), "print this text");
  return options;
}

inline po::options_description all_options(Command_line& command)
{
  po::options_description options = visible_options(command);
  po::options_description_easy_init add = options.add_options();
  add("file", po::value(&command.file));
  add("first-run", po::value(&command.first_run));
  return options;
}

} // namespace internal

// Throws an exception for wrong usage.
inline Command_line parse_command_line(const int argc, char* argv[])
{
  namespace po = boost::program_options;
  Command_line command;
  const po::options_description options = internal::all_options(command);
  po::positional_options_description positional;
  positional.add("folder", 1);
  po::variables_map values;
  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  po::store(po::command_line_parser(argc, argv).options(options).positional(positional).style(style).run(),
            values);
  po::notify(values);
  if(command.method != "direct" && command.method != "hierarchical") {
    throw std::runtime_error("--method is direct or hierarchical");
  }
  if(command.limits.seconds < 1 || !(command.limits.gigabytes > 0)) {
    throw std::runtime_error("--timeout and --memory take numbers above 0");
  }
  return command;
}

inline std::string help_text()
{
  Command_line command;
  std::ostringstream text;
  text << "sweep: flattens every component with a border of every mesh in a folder.\n\n"
          "The exit status is 0 only if there was no crash, no timeout, and no map that was called valid and "
          "is not.\n\n"
          "usage: sweep [FOLDER] [options]\n"
       << internal::visible_options(command);
  return text.str();
}

} // namespace sweep

#endif // SWEEP_COMMAND_LINE_H
