// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_COMMAND_LINE_H
#define HIERARCHICAL_COMMAND_LINE_H

#include "Task.h"

#include "../common/number_list.h"
#include "../common/run_child.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace hierarchical {

using namespace benchmarks;

struct Command_line
{
  std::string mesh = ABF_EXAMPLES_DIR "/shell.off";
  std::string data, parts = "speed,quality,rates,sequential,large,sweeps,polish";
  std::string sizes = "97000,388000,1552000", large_sizes = "388000,605846,698572,4241328";
  std::string rates = "80,85,90,92.5,95,97,98,99,99.5", sweeps = "0,1,2,3,4";
  std::string figure, output;
  int threads = 2, repeat = 3;
  Child_limits limits = {600, 16};
  bool help = false;

  Task task; // what a process that measures shall do

  static std::vector<std::size_t> triangles(const std::string& list, const std::string& option)
  {
    const std::vector<long> numbers = numbers_of_list<long>(list, option, 100, 1000000000);
    return {numbers.begin(), numbers.end()};
  }

  // The meshes of the parts that compare the quality: those in the folder, or else the one mesh
  std::vector<std::string> mesh_files() const
  {
    if(data.empty()) {
      return {mesh};
    }
    std::vector<std::string> files;
    for(const auto& entry : std::filesystem::directory_iterator(data)) {
      const std::string extension = entry.path().extension().string();
      if(extension == ".ply" || extension == ".off" || extension == ".obj" || extension == ".stl") {
        files.push_back(entry.path().string());
      }
    }
    std::sort(files.begin(), files.end());
    return files;
  }
};

namespace internal {

namespace po = boost::program_options;

template <class Value>
po::typed_value<Value>* option(Value& value, const char* name)
{
  return po::value(&value)->value_name(name)->default_value(value);
}

inline po::options_description visible_options(Command_line& command)
{
  po::options_description options("Options", 100, 60);
  po::options_description_easy_init add = options.add_options();
  add("mesh", po::value(&command.mesh)->value_name("FILE"),
      "a disk, which is simplified or subdivided; the word '--mesh' may be left out. By default the sea "
      "shell of the examples");
  add("data", po::value(&command.data)->value_name("FOLDER"),
      "disks for quality, sequential, sweeps and polish; by default only the one mesh");
  add("parts", option(command.parts, "PART,PART,..."), "what to measure");
  add("sizes", option(command.sizes, "N,N,..."),
      "numbers of triangles for speed; quality takes the second one");
  add("large", option(command.large_sizes, "N,N,..."), "numbers of triangles for large");
  add("rates", option(command.rates, "PERCENT,..."), "simplification rates for rates");
  add("sweeps", option(command.sweeps, "N,N,..."), "sweeps on each level for sweeps");
  add("figure", po::value(&command.figure)->value_name("NAME"),
      "what rates measures is also written to NAME.csv and drawn to NAME.svg, by gnuplot");
  add("threads", option(command.threads, "N"), "compared with one thread, in speed and large");
  add("repeat", option(command.repeat, "N"), "of how many processes each the medians are taken");
  add("timeout", option(command.limits.seconds, "SECONDS"), "limit of a process; it is killed then");
  add("memory", option(command.limits.gigabytes, "GB"), "limit of a process");
  add("output,o", po::value(&command.output)->value_name("FILE.md"), "write the report there as well");
  add("help,h", po::bool_switch(&command.help), "print this text");
  return options;
}

inline po::options_description all_options(Command_line& command)
{
  po::options_description options = visible_options(command);
  po::options_description_easy_init add = options.add_options();
  add("measure", po::value(&command.task.method));
  add("file", po::value(&command.task.file));
  add("on-cores", po::value(&command.task.threads));
  add("rate", po::value(&command.task.rate));
  add("with-sweeps", po::value(&command.task.sweeps));
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
  positional.add("mesh", 1);
  po::variables_map values;
  // No guessing: '--rate' is not short for '--rates'.
  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  po::store(po::command_line_parser(argc, argv).options(options).positional(positional).style(style).run(),
            values);
  po::notify(values);
  if(command.repeat < 1 || command.threads < 1 || command.limits.seconds < 1 ||
     !(command.limits.gigabytes > 0)) {
    throw std::runtime_error("--threads, --repeat, --timeout and --memory take numbers above 0");
  }
  return command;
}

inline std::string help_text()
{
  Command_line command;
  std::ostringstream text;
  text << "hierarchical: measures the hierarchical parameterizer against others.\n\n"
          "usage: hierarchical [FILE] [options]\n"
       << internal::visible_options(command);
  return text.str();
}

} // namespace hierarchical

#endif // HIERARCHICAL_COMMAND_LINE_H
