// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_COMPARISONS_H
#define HIERARCHICAL_COMPARISONS_H

// The parts that run variants of the method on the same meshes: other orders, numbers of sweeps, polishing.

#include "Command_line.h"
#include "Runner.h"
#include "measure.h"
#include "tables.h"

#include <string>
#include <vector>

namespace hierarchical {

inline std::string sequential_part(const Command_line& command)
{
  Table table({"mesh", "order", "triangles", "coarse triangles", "seconds", "coarsen", "solve", "refine",
               "kernel insertions", "% of vertices", "shear", "stretch", "flips"},
              2);
  for(const std::string& file : command.compared_files()) {
    const std::vector<Measurement> results = Runner(command).run({{habf, file}, {sequential, file}});
    for(const Measurement& m : results) {
      const std::string order = &m == &results.front() ? "by levels" : "sequential";
      if(!m.succeeded()) {
        table.add_failure({name_of_file(file), order}, m);
        continue;
      }
      table.add({name_of_file(file), order, count_cell(m["triangles"]), count_cell(m["coarse_triangles"]),
                 seconds_cell(m["seconds"]), seconds_cell(m["coarsen"]), seconds_cell(m["solve"]),
                 seconds_cell(m["refine"]), count_cell(m["kernel_insertions"]),
                 cell("%.4f", 100 * m["kernel_insertions"] / m["vertices"]), cell("%.4f", m["shear"]),
                 cell("%.4f", m["stretch"]), count_cell(m["flips"])});
    }
  }
  return "By levels is the library, on one thread. Sequential is the paper's Section 5: one vertex at a "
         "time from a priority queue, and back in reverse order, with harmonic weights and one harmonic "
         "smoothing of the vertex and its neighbours. Both use the same cost, vetoes, coarse solver and "
         "number of coarse vertices.\n\n" +
         table.text();
}

inline std::string sweeps_part(const Command_line& command)
{
  Table table(
      {"mesh", "sweeps on each level", "seconds", "refine", "shear", "stretch", "kernel insertions", "flips"},
      1);
  const std::vector<int> sweeps = numbers_of_list<int>(command.sweeps, "--sweeps", 0, 1000);
  for(const std::string& file : command.compared_files()) {
    std::vector<Task> tasks;
    for(const int number : sweeps) {
      tasks.emplace_back(habf, file);
      tasks.back().sweeps = number;
    }
    const std::vector<Measurement> results = Runner(command).run(tasks);
    for(std::size_t i = 0; i < tasks.size(); ++i) {
      const Measurement& m = results[i];
      const std::vector<std::string> cells = {name_of_file(file), std::to_string(tasks[i].sweeps)};
      if(!m.succeeded()) {
        table.add_failure(cells, m);
        continue;
      }
      table.add({cells[0], cells[1], seconds_cell(m["seconds"]), seconds_cell(m["refine"]),
                 cell("%.4f", m["shear"]), cell("%.4f", m["stretch"]), count_cell(m["kernel_insertions"]),
                 count_cell(m["flips"])});
    }
  }
  return "The hierarchical method at the default rate, on one thread, with `Hierarchical_options::sweeps` "
         "varied; the default is " +
         std::to_string(Task().sweeps) + ".\n\n" + table.text();
}

inline std::string polish_part(const Command_line& command)
{
  Table table(
      {"mesh", "method", "seconds", "polish", "Newton steps", "shear", "stretch", "flips", "replaced"}, 2);
  for(const std::string& file : command.compared_files()) {
    const std::vector<Task> tasks = {{direct, file}, {habf, file}, {polished, file}};
    const std::vector<Measurement> results = Runner(command).run(tasks);
    for(std::size_t i = 0; i < tasks.size(); ++i) {
      const Measurement& m = results[i];
      const bool is_polished = tasks[i].method == polished;
      if(!m.succeeded()) {
        table.add_failure({name_of_file(file), title(tasks[i].method)}, m);
        continue;
      }
      table.add({name_of_file(file), title(tasks[i].method), seconds_cell(m["seconds"]),
                 is_polished ? seconds_cell(m["polish"]) : "–",
                 tasks[i].method == habf ? "–" : count_cell(m["newton_steps"]), cell("%.4f", m["shear"]),
                 cell("%.4f", m["stretch"]), count_cell(m["flips"]),
                 !is_polished         ? "–"
                 : m["polished"] == 1 ? "yes"
                                      : "no"});
    }
  }
  return "Direct ABF++, the hierarchical one, and the latter as the start of the direct solver "
         "(`Hierarchical_options::polish`). Replaced: whether the direct solver's result was valid, and so "
         "was returned.\n\n" +
         table.text();
}

} // namespace hierarchical

#endif // HIERARCHICAL_COMPARISONS_H
