// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures the hierarchical parameterizer: speed, memory, distortion, against the direct one, CGAL's LSCM, hierarchical
// LSCM and the paper's order. Prints Markdown tables. `hierarchical horse.ply --data meshes`; see `--help`.

#include "common/describe_machine.h" // first: it includes <Eigen/SuperLUSupport>

#include "hierarchical/Command_line.h"
#include "hierarchical/comparisons.h"
#include "hierarchical/direct.h"
#include "hierarchical/large.h"
#include "hierarchical/measure.h"
#include "hierarchical/quality.h"
#include "hierarchical/rates.h"
#include "hierarchical/speed.h"

#include "common/Report.h"
#include "common/command_text.h"

#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace hierarchical {

struct Part
{
  const char* name;
  const char* title;
  std::string (*measure)(const Command_line&);
};

const Part& part(const std::string& name)
{
  static const Part parts[] = {{"speed", "Speed and memory", speed_part},
                               {"quality", "Distortion", quality_part},
                               {"rates", "Simplification rates", rates_part},
                               {"sequential", "Level by level, or one vertex at a time", sequential_part},
                               {"large", "Large surfaces", large_part},
                               {"sweeps", "Sweeps", sweeps_part},
                               {"polish", "Polishing", polish_part},
                               {"direct", "The direct method", direct_part}};
  for(const Part& part : parts) {
    if(name == part.name) {
      return part;
    }
  }
  throw std::runtime_error("there is no part '" + name + "'");
}

std::string caption(const Command_line& command)
{
  return "Medians of " + std::to_string(command.repeat) +
         " runs, each in a process of its own that has as many cores as threads, the BLAS on one thread. "
         "One thread where nothing else is said. A process was stopped after " +
         std::to_string(command.limits.seconds) + " s, and had " +
         format_number("%g GB of memory.\n", command.limits.gigabytes);
}

void run(const Command_line& command)
{
  std::vector<Part> parts; // all known before hours of measuring begin
  for(const std::string& name : words_of_list(command.parts)) {
    parts.push_back(part(name));
  }
  Report report(command.output);
  report.add("# Hierarchical parameterization\n\n" + command_text() + describe_machine() + "\n\n" +
             caption(command));
  for(const Part& part : parts) {
    report.add(std::string("\n## ") + part.title + "\n\n" + part.measure(command));
  }
}

} // namespace hierarchical

int main(int argc, char* argv[])
{
  using namespace hierarchical;
  try {
    const Command_line command = parse_command_line(argc, argv);
    if(command.help) {
      std::cout << help_text();
    } else if(!command.task.method.empty()) {
      std::cout << to_text(measure(command.task)) << std::flush;
    } else {
      run(command);
    }
    return EXIT_SUCCESS;
  } catch(const std::exception& error) {
    std::cerr << "hierarchical: " << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
