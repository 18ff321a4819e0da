// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_LARGE_H
#define HIERARCHICAL_LARGE_H

#include "Command_line.h"
#include "Runner.h"
#include "measure.h"
#include "tables.h"
#include "test_meshes.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace hierarchical {

namespace internal {

// A row of the paper's Table III: surfaces of that size, not ours.
struct Paper_row
{
  double triangles;
  double habf_seconds, hlscm_seconds; // NaN: failed

  double seconds(const std::string& method) const { return method == habf ? habf_seconds : hlscm_seconds; }
};

// The row of about that size, or nothing
inline const Paper_row* paper_row(const double triangles)
{
  static const Paper_row rows[] = {
      {605846, 107, 305}, {698572, 50, 351}, {4241328, 819, (std::numeric_limits<double>::quiet_NaN)()}};
  for(const Paper_row& row : rows) {
    if(std::abs(triangles / row.triangles - 1) < 0.02) {
      return &row;
    }
  }
  return nullptr;
}

struct Large_run
{
  std::string method;
  int threads;
  double triangles;
  Measurement measurement;

  double faces_per_second() const { return triangles / measurement["seconds"]; }

  // How many times as many faces a second as in the paper
  double over_paper() const
  {
    const Paper_row* const row = paper_row(triangles);
    return row == nullptr ? (std::numeric_limits<double>::quiet_NaN)()
                          : faces_per_second() * row->seconds(method) / row->triangles;
  }
};

inline std::vector<Large_run> measure_large(const Command_line& command)
{
  std::vector<Large_run> runs;
  for(const std::size_t triangles : triangles_of_list(command.large_sizes, "--large")) {
    const Temporary_folder folder;
    const std::string file = resized_mesh(command, folder, triangles, true);
    const std::vector<Task> tasks = {
        {habf, file}, {habf, file, command.threads}, {hlscm, file}, {hlscm, file, command.threads}};
    const std::vector<Measurement> results = Runner(command).run(tasks);
    for(std::size_t i = 0; i < tasks.size(); ++i) {
      const double known = results[i].succeeded() ? results[i]["triangles"] : static_cast<double>(triangles);
      runs.push_back({tasks[i].method, tasks[i].threads, known, results[i]});
    }
  }
  return runs;
}

inline std::string large_table(const std::vector<Large_run>& runs)
{
  Table table({"triangles", "method", "threads", "seconds", "shear", "stretch", "kernel insertions", "flips",
               "bytes a triangle", "faces a second", "times the paper's"},
              0);
  for(const Large_run& run : runs) {
    const Measurement& m = run.measurement;
    const std::vector<std::string> cells = {count_cell(run.triangles), title(run.method),
                                            std::to_string(run.threads)};
    if(!m.succeeded()) {
      table.add_failure(cells, m);
      continue;
    }
    table.add({cells[0], cells[1], cells[2], seconds_cell(m["seconds"]), cell("%.4f", m["shear"]),
               cell("%.4f", m["stretch"]), count_cell(m["kernel_insertions"]), count_cell(m["flips"]),
               count_cell(m["bytes"] / run.triangles), count_cell(run.faces_per_second()),
               cell("%.0f", run.over_paper())});
  }
  return table.text();
}

// The growth is that from the first size to the last one.
inline std::string large_targets(const std::vector<Large_run>& runs)
{
  Targets targets;
  double flips = 0;
  for(const Large_run& run : runs) {
    const std::string threads = ", " + std::to_string(run.threads) + " thread(s)";
    if(run.method == habf && run.triangles > 4e6) {
      targets.at_least("faces a second, times the paper's" + threads, "%.0f", run.over_paper(), 100);
    }
    for(const Large_run& first : runs) {
      if(run.method == habf && first.method == habf && first.threads == run.threads && run.triangles > 4e6 &&
         first.triangles < 4e5) {
        targets.at_most(format_number("time at %.0f triangles ", run.triangles) +
                            format_number("/ time at %.0f", first.triangles) + threads,
                        "%.1f", run.measurement["seconds"] / first.measurement["seconds"], 13);
      }
    }
    if(run.method == habf && run.triangles > 3e5) {
      targets.at_most(format_number("bytes a triangle, %.0f triangles", run.triangles) + threads, "%.0f",
                      run.measurement["bytes"] / run.triangles, 150);
    }
    flips += run.measurement.succeeded() ? run.measurement["flips"] : 0;
  }
  targets.at_most("flips of all", "%.0f", flips, 0);
  return targets.text();
}

} // namespace internal

inline std::string large_part(const Command_line& command)
{
  const std::vector<internal::Large_run> runs = internal::measure_large(command);
  return "The counterpart of the paper's Table III: " + name_of_file(command.mesh) +
         ", simplified and subdivided to the sizes there, each vertex then moved by a tenth of its "
         "shortest edge, at the default rate. The paper's surfaces are others of the same sizes (605,846 "
         "triangles: hierarchical ABF++ 107 s, hierarchical LSCM 305 s; 698,572: 50 s, 351 s; 4,241,328, "
         "at 98 %: 819 s, failed), on machines of 2004.\n\n" +
         internal::large_table(runs) + internal::large_targets(runs);
}

} // namespace hierarchical

#endif // HIERARCHICAL_LARGE_H
