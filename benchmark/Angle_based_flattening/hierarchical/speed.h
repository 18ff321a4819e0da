// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_SPEED_H
#define HIERARCHICAL_SPEED_H

#include "Command_line.h"
#include "Runner.h"
#include "measure.h"
#include "tables.h"
#include "test_meshes.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace hierarchical {

namespace internal {

// What was measured at one size, in the order of `speed_tasks()`
struct Speed
{
  double triangles;
  Measurement one_thread, more_threads, direct, lscm;

  double seconds_per_million() const { return one_thread["seconds"] / triangles * 1e6; }
  double over_one_thread(const Measurement& m) const { return m["seconds"] / one_thread["seconds"]; }
};

inline std::vector<Task> speed_tasks(const std::string& file, const int threads)
{
  return {{habf, file}, {habf, file, threads}, {direct, file}, {lscm, file}};
}

inline std::vector<Speed> measure_speed(const Command_line& command)
{
  std::vector<Speed> sizes;
  for(const std::size_t triangles : triangles_of_list(command.sizes, "--sizes")) {
    const Temporary_folder folder;
    const std::vector<Measurement> m =
        Runner(command).run(speed_tasks(resized_mesh(command, folder, triangles), command.threads));
    const double known = m[0].succeeded() ? m[0]["triangles"] : static_cast<double>(triangles);
    sizes.push_back({known, m[0], m[1], m[2], m[3]});
  }
  return sizes;
}

inline void add_speed_row(Table& table, const Speed& size, const std::string& method,
                          const std::string& threads, const Measurement& m)
{
  std::vector<std::string> cells = {title(method), threads, count_cell(size.triangles)};
  if(!m.succeeded()) {
    table.add_failure(cells, m);
    return;
  }
  cells.push_back(seconds_cell(m["seconds"]));
  cells.push_back(cell("%.2f", m["seconds"] / size.triangles * 1e6));
  for(const std::string& stage : stages()) {
    if(stage != "polish") {
      cells.push_back(seconds_cell(m[stage]));
    }
  }
  cells.push_back(count_cell(m["bytes"] / size.triangles));
  cells.push_back(count_cell(m["flips"]));
  table.add(cells);
}

inline std::string speed_table(const std::vector<Speed>& sizes, const int threads)
{
  std::vector<std::string> titles = {"method", "threads", "triangles", "seconds", "per million"};
  for(const std::string& stage : stages()) {
    if(stage != "polish") {
      titles.push_back(stage);
    }
  }
  titles.insert(titles.end(), {"bytes a triangle", "flips"});
  Table table(titles, 1);
  for(const Speed& size : sizes) {
    add_speed_row(table, size, habf, "1", size.one_thread);
    add_speed_row(table, size, habf, std::to_string(threads), size.more_threads);
    add_speed_row(table, size, direct, "1", size.direct);
    add_speed_row(table, size, lscm, "1", size.lscm);
  }
  return table.text();
}

inline std::string speed_ratios(const std::vector<Speed>& sizes, const int threads)
{
  Table table({"triangles", "direct ABF++ / hierarchical", "CGAL's LSCM / hierarchical",
               "one thread / " + std::to_string(threads) + " threads"},
              0);
  for(const Speed& size : sizes) {
    table.add({count_cell(size.triangles), cell("%.2f", size.over_one_thread(size.direct)),
               cell("%.2f", size.over_one_thread(size.lscm)),
               cell("%.2f", 1 / size.over_one_thread(size.more_threads))});
  }
  return "\n" + table.text();
}

// Small meshes have none.
inline std::string speed_targets(const std::vector<Speed>& sizes, const int threads)
{
  Targets targets;
  for(const Speed& size : sizes) {
    const std::string at = ", " + count_cell(size.triangles) + " triangles";
    if(size.triangles > 3e5) {
      targets.at_most("seconds per million triangles, one thread" + at, "%.2f", size.seconds_per_million(),
                      2.2);
      targets.at_least("one thread / " + std::to_string(threads) + " threads" + at, "%.2f",
                       1 / size.over_one_thread(size.more_threads), 1.3);
      targets.at_most("bytes a triangle, one thread" + at, "%.0f", size.one_thread["bytes"] / size.triangles,
                      150);
      targets.at_most("bytes a triangle, " + std::to_string(threads) + " threads" + at, "%.0f",
                      size.more_threads["bytes"] / size.triangles, 150);
    }
    if(size.triangles > 1.5e6) {
      targets.at_least("direct ABF++ / hierarchical" + at, "%.2f", size.over_one_thread(size.direct), 6);
      targets.at_least("CGAL's LSCM / hierarchical" + at, "%.2f", size.over_one_thread(size.lscm), 15);
    }
  }
  return targets.text();
}

} // namespace internal

inline std::string speed_part(const Command_line& command)
{
  const std::vector<internal::Speed> sizes = internal::measure_speed(command);
  return "The whole call of `parameterize()` on a mesh that is in memory, at the default rate, in seconds, "
         "with its stages. Memory: peak resident size during the call beyond that before it. Ratios are to "
         "the hierarchical method on one thread.\n\n" +
         internal::speed_table(sizes, command.threads) + internal::speed_ratios(sizes, command.threads) +
         internal::speed_targets(sizes, command.threads);
}

} // namespace hierarchical

#endif // HIERARCHICAL_SPEED_H
