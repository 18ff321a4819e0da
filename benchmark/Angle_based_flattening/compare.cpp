// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flattens meshes by ABF++ and the methods that it is compared with, side by side, and prints Markdown: the tables of the
// paper, ratios, and whether what the paper says is seen. `compare --quick --data meshes`; see `--help`.

#include "common/describe_machine.h" // first: it includes <Eigen/SuperLUSupport>

#include "compare/Command_line.h"
#include "compare/Results.h"
#include "compare/Runner.h"
#include "compare/Test_mesh.h"
#include "compare/csv.h"
#include "compare/growth.h"
#include "compare/measure.h"
#include "compare/plots.h"
#include "compare/relations.h"
#include "compare/tables.h"

#include "common/Report.h"
#include "common/command_text.h"
#include "methods/Method.h"

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace compare {

std::vector<Method_title> chosen_methods(const Command_line& command)
{
  std::vector<Method_title> chosen;
  for(const std::string& name : words_of_list(command.methods)) {
    chosen.push_back({name, ABF_benchmark::find_method(name).title});
  }
  if(chosen.empty()) {
    for(const ABF_benchmark::Method& method : ABF_benchmark::all_methods()) {
      chosen.push_back({method.name, method.title});
    }
  }
  return chosen;
}

std::string caption(const Command_line& command)
{
  return "\n\nMedians of up to " + std::to_string(command.repeat) +
         " runs, as many as fit into the limit of time, each in a process of its own. Cores: " +
         std::to_string(command.threads) +
         "; the BLAS on one thread. Seconds and memory (peak resident size) are those of the method alone, "
         "beyond "
         "the mesh in the form in which it takes it. Limits of a process: " +
         std::to_string(command.limits.seconds) + " s, " +
         format_number("%g GB of memory", command.limits.gigabytes) +
         ". A method that was stopped by them twice was not tried on larger meshes.\n";
}

void report_results(const Command_line& command, const Results& results, Report& report)
{
  report.add("\n## Table I: run times\n\nIn seconds, of meshes up to 60,000 faces.\n\n" +
             times_table(results));
  report.add(
      "\n## Table II: small to large meshes\n\nShear is that of Eq. 24, which depends on the direction of "
      "the axes; principal shear does not. Stretch is that of the mirror image where a triangle is flipped, "
      "and infinite where one has no area.\n\n" +
      distortions_table(results, 0, most_of_table_2));
  report.add("\n## Table III: very large meshes\n\n" +
             distortions_table(results, most_of_table_2, std::size_t(-1)));
  report.add("\n## Ratios to CGAL's LSCM\n\nGeometric means over the meshes that both methods could do, but "
             "for developable ones; of "
             "stretch, those where it is finite.\n\n" +
             ratios_table(results, "lscm"));
  report.add("\n## Growth\n\nOf the run time on one surface in several sizes.\n\n" + growth_table(results));
  report.add("\n## What the paper says\n\nQuotients on every mesh where both were measured, but for "
             "developable ones.\n\n" +
             relations_table(results));
  if(!command.plots.empty()) {
    report.add("\n## Plots\n\n" + draw_plots(results, command.plots));
  }
}

void run(const Command_line& command)
{
  Results results = {chosen_methods(command), {}};
  const std::vector<Test_mesh> meshes = find_meshes(command);
  if(meshes.empty()) {
    throw std::runtime_error("there is no mesh; see --help");
  }
  if(!command.plots.empty()) {
    std::filesystem::create_directories(command.plots);
  }
  Report report(command.output);
  report.add("# Methods of flattening\n\n" + command_text() + describe_machine() + caption(command));
  Runner runner(command, results.methods);
  for(const Test_mesh& mesh : meshes) {
    results.meshes.push_back(runner.run(mesh));
    if(!command.csv.empty()) {
      write_file(command.csv, csv(results));
    }
  }
  report_results(command, results, report);
}

std::string list_of_methods()
{
  std::string text = "\nMethods:\n";
  for(const ABF_benchmark::Method& method : ABF_benchmark::all_methods()) {
    text += "  " + method.name + ": " + method.title + "\n";
  }
  return text;
}

} // namespace compare

int main(int argc, char* argv[])
{
  using namespace compare;
  try {
    const Command_line command = parse_command_line(argc, argv);
    if(command.help) {
      std::cout << help_text() << list_of_methods();
    } else if(!command.run.empty()) {
      std::cout << to_text(measure(command)) << std::flush;
    } else {
      run(command);
    }
    return EXIT_SUCCESS;
  } catch(const std::exception& error) {
    std::cerr << "compare: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
