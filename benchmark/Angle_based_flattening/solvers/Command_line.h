// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SOLVERS_COMMAND_LINE_H
#define SOLVERS_COMMAND_LINE_H

#include "../common/number_list.h"
#include "../common/run_child.h"

#include <boost/program_options.hpp>

#include <cstddef>
#include <sstream>
#include <stdexcept>
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

  // The numbers in `sizes`
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
  add("mesh", po::value(&command.mesh)->value_name("FILE"),
      "a disk, which is simplified or subdivided; the word '--mesh' may be left out. By default the sea "
      "shell "
      "of the examples");
  add("sizes", option(command.sizes, "N,N,..."), "numbers of triangles");
  add("repeat", option(command.repeat, "N"), "of how many processes each the medians are taken");
  add("timeout", option(command.limits.seconds, "SECONDS"), "limit of a process; it is killed then");
  add("memory", option(command.limits.gigabytes, "GB"), "limit of a process");
  add("output,o", po::value(&command.output)->value_name("FILE.md"), "write the report there as well");
  add("help,h", po::bool_switch(&command.help), "print this text");
  return options;
}

} // namespace internal

// Throws an exception for wrong usage.
inline Command_line parse_command_line(const int argc, char* argv[])
{
  namespace po = boost::program_options;
  Command_line command;
  po::options_description options = internal::visible_options(command);
  options.add_options()("measure", po::value(&command.measure))("matrix", po::value(&command.matrix));
  po::positional_options_description positional;
  positional.add("mesh", 1);
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv).options(options).positional(positional).run(), values);
  po::notify(values);
  if(command.repeat < 1 || command.limits.seconds < 1 || !(command.limits.gigabytes > 0)) {
    throw std::runtime_error("--repeat, --timeout and --memory take numbers above 0");
  }
  return command;
}

inline std::string help_text()
{
  Command_line command;
  std::ostringstream text;
  text << "solvers: compares sparse direct solvers on the matrices of ABF++.\n\nusage: solvers [FILE] "
          "[options]\n"
       << internal::visible_options(command);
  return text.str();
}

} // namespace solvers

#endif // SOLVERS_COMMAND_LINE_H
