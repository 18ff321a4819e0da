// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_COMMAND_LINE_H
#define COMPARE_COMMAND_LINE_H

#include "../common/Command_options.h"
#include "../common/number_list.h"
#include "../common/run_child.h"

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace compare {

using namespace benchmarks;

struct Command_line
{
  std::vector<std::string> meshes, data; // files, or folders of them
  std::string base = ABF_EXAMPLES_DIR "/shell.off", sizes, methods;
  std::size_t least = 500, most = 10000000; // triangles of what is found in folders
  std::string csv, plots, output;
  int repeat = 3, threads = 1;
  Child_limits limits = {120, 16};
  bool quick = false, all = false, help = false;

  std::string run, file; // what a process that measures shall do

  std::vector<std::size_t> triangles() const { return triangles_of_list(sizes, "--sizes"); }
};

namespace internal {

inline void add_mesh_options(Command_line& command, Command_options& options)
{
  options.add("mesh", po::value(&command.meshes)->value_name("FILE"),
              "a mesh, or a folder of meshes; the word '--mesh' may be left out");
  options.may_be_left_out("mesh", -1);
  options.add("data", po::value(&command.data)->value_name("FOLDER"),
              "as above, but nothing is wrong if there is no such folder; may be given again");
  options.add("sizes", value_with_default(command.sizes, "N,N,..."),
              "numbers of triangles to which the base is simplified or subdivided, with noise");
  options.add("base", po::value(&command.base)->value_name("FILE"),
              "a disk. By default the examples' sea shell");
  options.add("least", value_with_default(command.least, "N"), "smaller meshes of folders are left out");
  options.add("most", value_with_default(command.most, "N"), "larger meshes of folders are left out");
}

inline Command_options options_of(Command_line& command)
{
  Command_options options;
  add_mesh_options(command, options);
  options.add("methods", value_with_default(command.methods, "NAME,NAME,..."),
              "as listed below; all if there is none");
  options.add("quick", po::bool_switch(&command.quick),
              "--sizes 1000,4000,16000,64000 --most 30000 --repeat 1 --timeout 8, which takes less than five "
              "minutes");
  options.add("all", po::bool_switch(&command.all),
              "--sizes 1000,4000,16000,64000,256000,1024000,4241328 --timeout 600, which takes hours");
  options.add_repeat(command.repeat);
  options.add_limits(
      command.limits,
      "limit of a process, which is stopped then, and of the time after which it is not repeated");
  options.add("threads", value_with_default(command.threads, "N"), "cores of a process");
  options.add("csv", po::value(&command.csv)->value_name("FILE.csv"), "write all figures there");
  options.add("plots", po::value(&command.plots)->value_name("FOLDER"),
              "draw time.svg and distortion.svg there, by gnuplot");
  options.add_output_and_help(command.output, command.help);
  options.add_hidden("run", po::value(&command.run));
  options.add_hidden("file", po::value(&command.file));
  return options;
}

// What the presets say where the command line says nothing.
inline void apply_presets(const po::variables_map& values, Command_line& command)
{
  const auto set = [&](const char* name, auto& value, const auto& preset) {
    if(values[name].defaulted()) {
      value = preset;
    }
  };
  if(command.quick) {
    set("sizes", command.sizes, "1000,4000,16000,64000");
    set("most", command.most, 30000);
    set("repeat", command.repeat, 1);
    set("timeout", command.limits.seconds, 8);
  } else if(command.all) {
    set("sizes", command.sizes, "1000,4000,16000,64000,256000,1024000,4241328");
    set("timeout", command.limits.seconds, 600);
  }
}

} // namespace internal

// Throws an exception for wrong usage.
inline Command_line parse_command_line(const int argc, char* argv[])
{
  Command_line command;
  const po::variables_map values = internal::options_of(command).parse(argc, argv);
  internal::apply_presets(values, command);
  if(command.quick && command.all) {
    throw std::runtime_error("--quick and --all exclude each other");
  }
  require_positive("--threads, --repeat, --timeout and --memory", command.threads, command.repeat,
                   command.limits.seconds, command.limits.gigabytes);
  return command;
}

// Without the methods, which follow
inline std::string help_text()
{
  Command_line command;
  return internal::options_of(command).help_text(
      "compare: methods of flattening side by side, in the tables of the ABF++ paper.\n\n"
      "usage: compare [FILE|FOLDER...] [options]");
}

} // namespace compare

#endif // COMPARE_COMMAND_LINE_H
