// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shows how the error of the greedy unfolding accumulates (Section 4 of the paper), and that of our layouts does not: the
// largest closing error against the number of triangles, for the same angles. Prints a Markdown table.
// `unfolding --sizes 1000,10000 --svg unfolding.svg`; see `--help`.

#include "common/describe_machine.h" // first: it includes <Eigen/SuperLUSupport>

#include "solvers/newton_systems.h"

#include "common/Command_options.h"
#include "common/command_text.h"
#include "common/format.h"
#include "common/number_list.h"
#include "unfolding/Closing_errors.h"
#include "unfolding/plot.h"

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace unfolding {

using benchmarks::format_number;

struct Command_line
{
  std::string mesh = ABF_EXAMPLES_DIR "/shell.off";
  std::string sizes = "1000,3000,10000,30000,100000,300000";
  std::string tolerances = "1,1e-3,1e-6";
  std::string svg;
  bool help = false;
};

benchmarks::Command_options options_of(Command_line& command)
{
  namespace po = boost::program_options;
  using benchmarks::value_with_default;
  benchmarks::Command_options options;
  options.add("mesh", value_with_default(command.mesh, "FILE"), "a disk, which is simplified or subdivided");
  options.add("sizes", value_with_default(command.sizes, "N,N,..."), "numbers of triangles");
  options.add("tolerances", value_with_default(command.tolerances, "X,X,..."),
              "where the solver of the angles stops: at that norm of grad F");
  options.add("svg", po::value(&command.svg)->value_name("FILE"),
              "draw the errors into that file, with gnuplot");
  options.add("help,h", po::bool_switch(&command.help), "print this text");
  return options;
}

std::vector<double> numbers(const std::string& list)
{
  std::vector<double> result;
  for(const std::string& word : benchmarks::words_of_list(list)) {
    result.push_back(std::stod(word));
    benchmarks::require_positive("--sizes and --tolerances", result.back());
  }
  return result;
}

Chart chart_of_size(const benchmarks::Mesh& base, double triangles)
{
  const benchmarks::Mesh mesh = benchmarks::resize_mesh(base, static_cast<std::size_t>(triangles));
  abf::Chart_reader<benchmarks::Mesh> reader(mesh);
  if(const auto defect = reader.read(CGAL::Polygon_mesh_processing::longest_border(mesh).first))
    throw std::runtime_error("the mesh cannot be flattened: " + defect.message);
  return reader.chart;
}

std::string row(const Closing_errors& errors)
{
  std::vector<std::string> cells = {std::to_string(errors.triangles), format_number("%g", errors.tolerance),
                                    format_number("%.1e", errors.residual)};
  for(const Layout_errors& layout : errors.layouts) {
    cells.push_back(format_number("%.1e", layout.closing_error));
    cells.push_back(std::to_string(layout.flips));
  }
  return benchmarks::markdown_row(cells);
}

void run(const Command_line& command)
{
  const benchmarks::Mesh base = benchmarks::read_mesh(command.mesh);
  const std::vector<double> tolerances = numbers(command.tolerances);
  std::vector<Closing_errors> results;
  std::vector<std::string> titles = {"triangles", "norm of grad F", "largest residual"};
  for(const char* title : layout_titles) {
    titles.push_back(title);
    titles.push_back("flips");
  }
  std::cout << "# Closing errors of layouts\n\n" + benchmarks::command_text() +
                   benchmarks::describe_machine() +
                   "\n\nThe largest closing error of the triangles, relative to their size, of three "
                   "layouts of the same angles.\n\n";
  std::cout << benchmarks::markdown_head(titles, 0) << std::flush;
  for(const double size : numbers(command.sizes)) {
    const Chart chart = chart_of_size(base, size);
    for(const double tolerance : tolerances) {
      results.push_back(measure(chart, tolerance));
      std::cout << row(results.back()) << std::flush;
    }
  }
  if(!command.svg.empty())
    plot(results, tolerances, command.svg);
}

} // namespace unfolding

int main(int argc, char* argv[])
{
  try {
    unfolding::Command_line command;
    const benchmarks::Command_options options = unfolding::options_of(command);
    options.parse(argc, argv);
    if(command.help)
      std::cout << options.help_text("unfolding: closing errors of layouts of the same angles.\n");
    else
      unfolding::run(command);
    return EXIT_SUCCESS;
  } catch(const std::exception& error) {
    std::cerr << "unfolding: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
