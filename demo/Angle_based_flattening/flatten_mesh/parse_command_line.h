// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PARSE_COMMAND_LINE_H
#define FLATTEN_MESH_PARSE_COMMAND_LINE_H

#include "Command_line.h"
#include "check_outputs.h"
#include "texts.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

inline void check_files(const Command_line& command)
{
  if(command.input.empty()) {
    throw Usage_error(
        "no input: name a mesh file, as in 'flatten_mesh scan.ply --output flat.obj'; see --help");
  }
  check_outputs(command);
#ifndef ABF_WITH_PNG
  if(!command.picture.empty()) {
    throw Usage_error(
        "this program was built without libpng, which --picture needs: install libpng-dev and build "
        "it again, or use --svg");
  }
#endif
}

inline void check_numbers(const Command_line& command)
{
  const auto check = [](const bool is_right, const std::string& rule) {
    if(!is_right) {
      throw Usage_error(rule + "; see --help");
    }
  };
  const SMP::ABF_plus_plus_options& abf = command.options;
  const SMP::Hierarchical_options& hierarchical = command.hierarchical;
  const double rate = hierarchical.simplification_rate;
  check(std::isfinite(command.stretch_bound) && command.stretch_bound > 1,
        "--stretch-bound takes a number above 1");
  check(command.component >= 0, "--component counts from 0");
  check(command.border >= 0, "--border counts from 0");
  check(std::isfinite(abf.barrier) && abf.barrier >= 0, "--barrier takes a number of at least 0");
  check(std::isfinite(abf.tolerance) && abf.tolerance >= 1e-14,
        "--tolerance takes a number of at least 1e-14");
  check(rate > 0 && rate < 1, "--simplification-rate takes a number between 0 and 1");
  check(hierarchical.sweeps >= 0 && hierarchical.sweeps <= 1000, "--sweeps takes a number from 0 to 1000");
  check(hierarchical.angle_sweeps >= 0 && hierarchical.angle_sweeps <= 1000,
        "--angle-sweeps takes a number from 0 to 1000");
  check(abf.area_weight >= 0 && abf.area_weight <= 1, "--area-weight takes a number from 0 to 1");
  check(abf.clearance > 0 && abf.clearance <= 1, "--clearance takes a number above 0 and at most 1");
  check(abf.threads >= 0 && abf.threads <= 1024, "--threads takes a number from 0 to 1024");
  check(abf.max_iterations >= 1, "--max-iterations takes a number of at least 1");
}

inline void check_seams(const boost::program_options::variables_map& values, Command_line& command)
{
  command.asks_for_stretch = !values["stretch-bound"].defaulted();
  if(command.asks_for_stretch && command.cut != "auto") {
    throw Usage_error("--stretch-bound goes with --cut auto only");
  }
  if(!command.seams.empty() && command.seams != standard_output && !is_selection_file(command.seams) &&
     !is_other_file(resolved(command.seams))) {
    throw Usage_error("--seams takes a name that ends with .selection.txt");
  }
}

// Turns the names of methods into the parameterizer's options.
inline void check_injective(const boost::program_options::variables_map& values, const Command_line& command)
{
  for(const char* option : {"area-weight", "clearance"}) {
    if(!values[option].defaulted() && !command.options.injective) {
      throw Usage_error(std::string("--") + option + " goes with --injective only");
    }
  }
  if(command.options.injective && command.split_overlaps) {
    throw Usage_error("--injective and --split-overlaps exclude each other: in an injective map nothing "
                      "overlaps that could be split");
  }
}

inline void understand_names(Command_line& command)
{
  using Options = SMP::ABF_plus_plus_options;
  using Names = std::vector<std::string>;
  const auto check = [](const std::string& option, const std::string& name, const Names& known) {
    if(std::find(known.begin(), known.end(), name) == known.end()) {
      throw Usage_error("unknown --" + option + " '" + name + "': it is one of " +
                        boost::algorithm::join(known, ", "));
    }
  };
  check("method", command.method, {"direct", "hierarchical", "auto"});
  if(!is_selection_file(command.cut)) {
    check("cut", command.cut, {"auto", "topology", "none", "the name of a .selection.txt file"});
  }
  check("holes", command.holes, {"solve", "fill", "refuse"});
  check("repair", command.repair, {"on", "off"});
  check("solver", command.solver, {"superlu", "eigen", "cholmod"});
  check("layout", command.layout, {"auto", "exact", "least-squares"});
  check("step", command.step, {"newton", "sqp"});
  check("linear-solver", command.linear_solver, {"iterative", "direct"});
#ifndef ABF_WITH_CHOLMOD
  if(command.solver == "cholmod") {
    throw Usage_error("this program was built without CHOLMOD: use --solver superlu or --solver eigen");
  }
#endif
  command.options.layout = command.layout == "exact"           ? Options::EXACT_LAYOUT
                           : command.layout == "least-squares" ? Options::LEAST_SQUARES_LAYOUT
                                                               : Options::AUTOMATIC_LAYOUT;
  command.options.linear_solver = command.linear_solver == "direct" ? Options::DIRECT : Options::ITERATIVE;
  command.options.step = command.step == "sqp" ? Options::SEQUENTIAL_LINEARLY_CONSTRAINED : Options::NEWTON;
  command.options.holes = command.holes == "solve"  ? Options::SOLVE
                          : command.holes == "fill" ? Options::FILL
                                                    : Options::REFUSE;
}

// What is not given is chosen for a result close to that of the direct method.
inline void refine_method(const boost::program_options::variables_map& values,
                          SMP::Hierarchical_options& hierarchical)
{
  hierarchical.energy_tolerance = 0.01;
  if(values["simplification-rate"].defaulted()) {
    hierarchical.simplification_rate = 0.85;
  }
  if(values["angle-sweeps"].defaulted()) {
    hierarchical.angle_sweeps = 20;
  }
}

inline boost::program_options::variables_map values_of(const int argc, const char* const argv[],
                                                       Command_line& command)
{
  namespace po = boost::program_options;
  namespace style = po::command_line_style;
  const po::options_description options = all_options(command);
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map values;
  po::store(po::command_line_parser(argc, argv)
                .options(options)
                .positional(positional)
                .style(style::unix_style & ~style::allow_guessing)
                .run(),
            values);
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

inline void check_names_of_files(const boost::program_options::variables_map& values)
{
  for(const char* option : {"input", "output", "svg", "picture", "seams", "json"}) {
    if(values.count(option) != 0 && values[option].as<std::string>().empty()) {
      throw Usage_error(std::string("the name after --") + option + " is empty: give the name of a file");
    }
  }
}

} // namespace internal

// Throws a `Usage_error` for wrong usage. `command` contains what was understood until then.
inline void parse_command_line(const int argc, const char* const argv[], Command_line& command)
{
  namespace po = boost::program_options;
  po::variables_map values;
  try {
    values = internal::values_of(argc, argv, command);
  } catch(const po::too_many_positional_options_error&) {
    internal::find_json(argc, argv, command);
    throw Usage_error("more than one input: name one mesh file; see --help");
  } catch(const po::error& error) {
    internal::find_json(argc, argv, command);
    throw Usage_error(std::string(error.what()) + "; see --help");
  }
  if(!command.help && !command.version) {
    internal::check_names_of_files(values);
    internal::check_files(command);
    internal::check_numbers(command);
    internal::understand_names(command);
    internal::check_seams(values, command);
    internal::check_injective(values, command);
    if(command.method == "auto" && !command.options.injective) {
      internal::refine_method(values, command.hierarchical);
    }
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PARSE_COMMAND_LINE_H
