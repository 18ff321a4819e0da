// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flattens every component with a border of every mesh in a folder, each file in a process of its own, and looks at each
// map with the exact certificate, whatever the parameterizer said. Prints a Markdown table; see `--help`.

#include "sweep/Command_line.h"
#include "sweep/Run.h"
#include "sweep/flatten_file.h"
#include "sweep/report.h"

#include "common/Report.h"
#include "common/mesh_files.h"

#include <cstddef>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

namespace sweep {

namespace fs = std::filesystem;

// After a crash or a timeout another process goes on with the next run.
File_results flatten_in_children(const std::string& file, const Command_line& command)
{
  File_results results;
  while(true) {
    const std::size_t before = results.runs.size();
    const Child_result child = run_child(
        {"--file", file, "--method", command.method, "--first-run", std::to_string(before)}, command.limits);
    const std::string failure = child.failure(command.limits);
    const bool ended = take_output(child.output, results);
    if(failure.empty()) {
      return results;
    }
    if(ended) { // it was not at a run
      results.fault = failure;
      return results;
    }
    results.runs.back().fault = failure;
  }
}

bool run(const Command_line& command)
{
  Report report(command.output);
  report.add("# Sweep, " + command.method + " method\n\n" + table_head());
  Summary summary;
  for(const fs::path& file : mesh_files<fs::recursive_directory_iterator>(command.folder)) {
    File_results results = flatten_in_children(file.string(), command);
    results.file = file.lexically_relative(command.folder).string();
    report.add(table_rows(results));
    summary.add(results);
  }
  report.add("\n## Summary\n\n" + summary.text());
  return summary.faults.empty();
}

} // namespace sweep

int main(int argc, char* argv[])
{
  using namespace sweep;
  try {
    const Command_line command = parse_command_line(argc, argv);
    if(command.help) {
      std::cout << help_text();
    } else if(!command.file.empty()) {
      flatten_file(command.file, command.method, command.first_run);
    } else if(!run(command)) {
      return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
  } catch(const std::exception& error) {
    std::cerr << "sweep: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
