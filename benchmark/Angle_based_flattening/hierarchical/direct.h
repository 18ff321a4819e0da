// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The direct method: where its time goes, and how time and memory grow.

#ifndef HIERARCHICAL_DIRECT_H
#define HIERARCHICAL_DIRECT_H

#include "Command_line.h"
#include "Runner.h"
#include "measure.h"
#include "tables.h"
#include "test_meshes.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hierarchical {

namespace internal {

inline void add_direct_row(Table& table, const Task& task, const Measurement& m, const Measurement& smallest)
{
  std::vector<std::string> cells = {count_cell(m["triangles"]), std::to_string(task.threads)};
  if(!m.succeeded()) {
    table.add_failure(cells, m);
    return;
  }
  cells.push_back(seconds_cell(m["seconds"]));
  for(const std::string& stage : direct_stages()) {
    cells.push_back(cell("%.1f", 100 * m[stage] / m["seconds"]));
  }
  for(const char* count : {"newton_steps", "cg_steps", "factorizations"}) {
    cells.push_back(count_cell(m[count]));
  }
  cells.push_back(count_cell(m["bytes"] / m["triangles"]));
  for(const char* quantity : {"triangles", "seconds", "bytes"}) {
    cells.push_back(cell("%.1f", m[quantity] / smallest[quantity]));
  }
  cells.push_back(count_cell(m["flips"]));
  table.add(cells);
}

} // namespace internal

inline std::string direct_part(const Command_line& command)
{
  std::vector<std::string> titles = {"triangles", "threads", "seconds"};
  for(const std::string& stage : direct_stages()) {
    titles.push_back(stage + ", %");
  }
  titles.insert(titles.end(), {"Newton steps", "CG steps", "factored", "bytes a triangle",
                               "triangles / smallest", "time", "memory", "flips"});
  Table table(titles, 0);
  std::vector<Measurement> smallest; // with each number of threads
  for(const std::size_t triangles : triangles_of_list(command.sizes, "--sizes")) {
    const Temporary_folder folder;
    const std::string file = resized_mesh(command, folder, triangles);
    const std::vector<Task> tasks = {{direct, file, 1}, {direct, file, command.threads}};
    const std::vector<Measurement> measurements = Runner(command).run(tasks);
    if(smallest.empty()) {
      smallest = measurements;
    }
    for(std::size_t k = 0; k < tasks.size(); ++k) {
      internal::add_direct_row(table, tasks[k], measurements[k], smallest[k]);
    }
  }
  return "Direct ABF++: shares of its stages, and growth from the smallest size on, as quotients.\n\n" +
         table.text();
}

} // namespace hierarchical

#endif // HIERARCHICAL_DIRECT_H
