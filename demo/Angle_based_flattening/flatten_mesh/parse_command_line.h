// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PARSE_COMMAND_LINE_H
#define FLATTEN_MESH_PARSE_COMMAND_LINE_H

#include "Command_line.h"
#include "texts.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline bool is_same_file(const std::string& a, const std::string& b)
{
  if(a.empty() || b.empty()) {
    return false;
  }
  std::error_code error;
  return std::filesystem::weakly_canonical(a, error) == std::filesystem::weakly_canonical(b, error) &&
         (std::filesystem::is_regular_file(a, error) || !std::filesystem::exists(a, error));
}

inline void check_files(const Command_line& command)
{
  if(command.input.empty()) {
    throw Input_error(
        "no input: name a mesh file, as in 'flatten_mesh scan.ply --output flat.obj'; see --help");
  }
  const std::vector<std::string> outputs = {command.output, command.svg, command.picture, command.json};
  for(std::size_t i = 0; i < outputs.size(); ++i) {
    if(is_same_file(command.input, outputs[i])) {
      throw Input_error("'" + outputs[i] + "' would overwrite the input: choose another name");
    }
    for(std::size_t j = 0; j < i; ++j) {
      if(is_same_file(outputs[j], outputs[i])) {
        throw Input_error(
            "two outputs have the same name: choose different ones for --output, --svg, --picture "
            "and --json");
      }
    }
  }
#ifndef ABF_WITH_PNG
  if(!command.picture.empty()) {
    throw Input_error(
        "this program was built without libpng, which --picture needs: install libpng-dev and build "
        "it again, or use --svg");
  }
#endif
}

inline void check_numbers(const Command_line& command)
{
  const auto check = [](const bool is_right, const std::string& rule) {
    if(!is_right) {
      throw Input_error(rule + "; see --help");
    }
  };
  const SMP::ABF_plus_plus_options& abf = command.options;
  const SMP::Hierarchical_options& hierarchical = command.hierarchical;
  const double rate = hierarchical.simplification_rate;
  check(command.component >= 0, "--component counts from 0");
  check(command.border >= 0, "--border counts from 0");
  check(std::isfinite(abf.barrier) && abf.barrier >= 0, "--barrier takes a number of at least 0");
  check(std::isfinite(abf.tolerance) && abf.tolerance > 0, "--tolerance takes a number above 0");
  check(rate > 0 && rate < 1, "--rate takes a number between 0 and 1");
  check(hierarchical.sweeps >= 0 && hierarchical.angle_sweeps >= 0 && abf.threads >= 0,
        "--sweeps, --angle-sweeps and --threads take a number of at least 0");
  check(abf.max_iterations >= 1, "--max-iterations takes a number of at least 1");
}

// Turns the names of methods into the parameterizer's options.
inline void understand_names(Command_line& command)
{
  using Options = SMP::ABF_plus_plus_options;
  using Names = std::vector<std::string>;
  const auto check = [](const std::string& option, const std::string& name, const Names& known) {
    if(std::find(known.begin(), known.end(), name) == known.end()) {
      throw Input_error("unknown --" + option + " '" + name + "': it is one of " +
                        boost::algorithm::join(known, ", "));
    }
  };
  check("method", command.method, {"direct", "hierarchical", "auto"});
  check("holes", command.holes, {"close", "open"});
  check("repair", command.repair, {"on", "off"});
  check("solver", command.solver, {"superlu", "eigen", "cholmod"});
  check("layout", command.layout, {"auto", "exact", "least-squares"});
  check("step", command.step, {"newton", "sqp"});
  check("linear-solver", command.linear_solver, {"iterative", "direct"});
#ifndef ABF_WITH_CHOLMOD
  if(command.solver == "cholmod") {
    throw Input_error("this program was built without CHOLMOD: use --solver superlu or --solver eigen");
  }
#endif
  command.options.layout = command.layout == "exact"           ? Options::EXACT_LAYOUT
                           : command.layout == "least-squares" ? Options::LEAST_SQUARES_LAYOUT
                                                               : Options::AUTOMATIC_LAYOUT;
  command.options.linear_solver = command.linear_solver == "direct" ? Options::DIRECT : Options::ITERATIVE;
  command.options.step = command.step == "sqp" ? Options::SEQUENTIAL_LINEARLY_CONSTRAINED : Options::NEWTON;
  command.options.allow_holes = true;
}

} // namespace internal

// Throws an `Input_error` for wrong usage.
inline Command_line parse_command_line(const int argc, const char* const argv[])
{
  namespace po = boost::program_options;
  Command_line command;
  const po::options_description options = internal::all_options(command);
  po::positional_options_description positional;
  positional.add("input", 1);
  try {
    namespace style = po::command_line_style;
    po::variables_map values;
    po::store(po::command_line_parser(argc, argv)
                  .options(options)
                  .positional(positional)
                  .style(style::unix_style & ~style::allow_guessing)
                  .run(),
              values);
    po::notify(values);
  } catch(const po::too_many_positional_options_error&) {
    throw Input_error("more than one input: name one mesh file; see --help");
  } catch(const po::error& error) {
    throw Input_error(std::string(error.what()) + "; see --help");
  }
  if(!command.help) {
    internal::check_files(command);
    internal::check_numbers(command);
    internal::understand_names(command);
  }
  return command;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PARSE_COMMAND_LINE_H
