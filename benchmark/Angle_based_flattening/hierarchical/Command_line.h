// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_COMMAND_LINE_H
#define HIERARCHICAL_COMMAND_LINE_H

#include "Task.h"

#include "../common/Command_options.h"
#include "../common/mesh_files.h"
#include "../common/number_list.h"
#include "../common/run_child.h"

#include <filesystem>
#include <string>
#include <vector>

namespace hierarchical {

using namespace benchmarks;

struct Command_line
{
  std::string mesh = ABF_EXAMPLES_DIR "/shell.off";
  std::string data, parts = "speed,quality,rates,sequential,large,sweeps,polish,direct";
  std::string sizes = "97000,388000,1552000", large_sizes = "388000,605846,698572,4241328";
  std::string rates = "80,85,90,92.5,95,97,98,99,99.5", sweeps = "0,1,2,3,4";
  std::string figure, output;
  int threads = 2, repeat = 3;
  Child_limits limits = {600, 16};
  bool help = false;

  Task task; // what a process that measures shall do

  // The meshes of the parts that compare the quality: those in the folder, or else the one mesh
  std::vector<std::string> compared_files() const
  {
    if(data.empty()) {
      return {mesh};
    }
    std::vector<std::string> files;
    for(const std::filesystem::path& file : mesh_files(data)) {
      files.push_back(file.string());
    }
    return files;
  }
};

namespace internal {

inline Command_options options_of(Command_line& command)
{
  Command_options options;
  options.add_base_mesh(command.mesh);
  options.add("data", po::value(&command.data)->value_name("FOLDER"),
              "disks for quality, sequential, sweeps and polish; by default only the one mesh");
  options.add("parts", value_with_default(command.parts, "PART,PART,..."), "what to measure");
  options.add("sizes", value_with_default(command.sizes, "N,N,..."),
              "numbers of triangles for speed and direct; quality takes the second one");
  options.add("large", value_with_default(command.large_sizes, "N,N,..."), "numbers of triangles for large");
  options.add("rates", value_with_default(command.rates, "PERCENT,..."), "simplification rates for rates");
  options.add("sweeps", value_with_default(command.sweeps, "N,N,..."), "sweeps on each level for sweeps");
  options.add("figure", po::value(&command.figure)->value_name("NAME"),
              "what rates measures is also written to NAME.csv and drawn to NAME.svg, by gnuplot");
  options.add("threads", value_with_default(command.threads, "N"),
              "compared with one thread, in speed and large");
  options.add_repeat(command.repeat);
  options.add_limits(command.limits);
  options.add_output_and_help(command.output, command.help);
  options.add_hidden("measure", po::value(&command.task.method));
  options.add_hidden("file", po::value(&command.task.file));
  options.add_hidden("on-cores", po::value(&command.task.threads));
  options.add_hidden("rate", po::value(&command.task.rate));
  options.add_hidden("with-sweeps", po::value(&command.task.sweeps));
  return options;
}

} // namespace internal

// Throws an exception for wrong usage.
inline Command_line parse_command_line(const int argc, char* argv[])
{
  Command_line command;
  internal::options_of(command).parse(argc, argv);
  require_positive("--threads, --repeat, --timeout and --memory", command.threads, command.repeat,
                   command.limits.seconds, command.limits.gigabytes);
  return command;
}

inline std::string help_text()
{
  Command_line command;
  return internal::options_of(command).help_text(
      "hierarchical: measures the hierarchical parameterizer against others.\n\n"
      "usage: hierarchical [FILE] [options]");
}

} // namespace hierarchical

#endif // HIERARCHICAL_COMMAND_LINE_H
