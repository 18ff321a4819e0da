// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_COMMAND_LINE_H
#define COMPARE_COMMAND_LINE_H

#include "../common/number_list.h"
#include "../common/run_child.h"

#include <boost/program_options.hpp>

#include <cstddef>
#include <sstream>
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

  std::vector<std::size_t> triangles() const
  {
    const std::vector<long> numbers = numbers_of_list<long>(sizes, "--sizes", 100, 1000000000);
    return {numbers.begin(), numbers.end()};
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
  add("mesh", po::value(&command.meshes)->value_name("FILE"),
      "a mesh, or a folder of meshes; the word '--mesh' may be left out");
  add("data", po::value(&command.data)->value_name("FOLDER"),
      "as above, but nothing is wrong if there is no such folder; may be given again");
  add("sizes", option(command.sizes, "N,N,..."),
      "numbers of triangles to which the base is simplified or subdivided, with noise");
  add("base", po::value(&command.base)->value_name("FILE"), "a disk. By default the examples' sea shell");
  add("least", option(command.least, "N"), "smaller meshes of folders are left out");
  add("most", option(command.most, "N"), "larger meshes of folders are left out");
  add("methods", option(command.methods, "NAME,NAME,..."), "as listed below; all if there is none");
  add("quick", po::bool_switch(&command.quick),
      "--sizes 1000,4000,16000,64000 --most 30000 --repeat 1 --timeout 8, which takes less than five "
      "minutes");
  add("all", po::bool_switch(&command.all),
      "--sizes 1000,4000,16000,64000,256000,1024000,4241328 --timeout 600, which takes hours");
  add("repeat", option(command.repeat, "N"), "of how many processes each the medians are taken");
  add("timeout", option(command.limits.seconds, "SECONDS"),
      "limit of a process, which is stopped then, and of the time after which it is not repeated");
  add("memory", option(command.limits.gigabytes, "GB"), "limit of a process");
  add("threads", option(command.threads, "N"), "cores of a process");
  add("csv", po::value(&command.csv)->value_name("FILE.csv"), "write all figures there");
  add("plots", po::value(&command.plots)->value_name("FOLDER"),
      "draw time.svg and distortion.svg there, by gnuplot");
  add("output,o", po::value(&command.output)->value_name("FILE.md"), "write the report there as well");
  add("help,h", po::bool_switch(&command.help), "print this text");
  return options;
}

inline po::options_description all_options(Command_line& command)
{
  po::options_description options = visible_options(command);
  po::options_description_easy_init add = options.add_options();
  add("run", po::value(&command.run));
  add("file", po::value(&command.file));
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
  namespace po = boost::program_options;
  Command_line command;
  const po::options_description options = internal::all_options(command);
  po::positional_options_description positional;
  positional.add("mesh", -1);
  po::variables_map values;
  const int style = po::command_line_style::default_style & ~po::command_line_style::allow_guessing;
  po::store(po::command_line_parser(argc, argv).options(options).positional(positional).style(style).run(),
            values);
  po::notify(values);
  internal::apply_presets(values, command);
  if(command.quick && command.all) {
    throw std::runtime_error("--quick and --all exclude each other");
  }
  if(command.repeat < 1 || command.threads < 1 || command.limits.seconds < 1 ||
     !(command.limits.gigabytes > 0)) {
    throw std::runtime_error("--threads, --repeat, --timeout and --memory take numbers above 0");
  }
  return command;
}

// Without the methods, which follow
inline std::string help_text()
{
  Command_line command;
  std::ostringstream text;
  text << "compare: methods of flattening side by side, in the tables of the ABF++ paper.\n\n"
          "usage: compare [FILE|FOLDER...] [options]\n"
       << internal::visible_options(command);
  return text.str();
}

} // namespace compare

#endif // COMPARE_COMMAND_LINE_H
