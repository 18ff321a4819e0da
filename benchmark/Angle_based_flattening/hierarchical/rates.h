// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_RATES_H
#define HIERARCHICAL_RATES_H

#include "Command_line.h"
#include "Runner.h"
#include "measure.h"
#include "tables.h"

#include "../common/Report.h"
#include "../common/plot.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace hierarchical {

namespace internal {

// The first task is the direct method.
inline std::vector<Task> rate_tasks(const Command_line& command)
{
  std::vector<Task> tasks = {{direct, command.mesh}};
  for(const double percent : numbers_of_list<double>(command.rates, "--rates", 1, 99.99)) {
    tasks.emplace_back(habf, command.mesh);
    tasks.back().rate = percent / 100;
  }
  return tasks;
}

inline std::string rates_table(const std::vector<Task>& tasks, const std::vector<Measurement>& results)
{
  Table table({"rate", "coarse triangles", "seconds", "shear", "rise", "stretch", "rise", "kernel insertions",
               "retries", "flips"},
              1);
  const Measurement& d = results.front();
  for(std::size_t i = 0; i < tasks.size(); ++i) {
    const Measurement& m = results[i];
    const std::string rate = i == 0 ? "direct" : format_number("%g %%", 100 * tasks[i].rate);
    if(!m.succeeded()) {
      table.add_failure({rate}, m);
      continue;
    }
    table.add({rate, count_cell(m["coarse_triangles"]), seconds_cell(m["seconds"]), cell("%.4f", m["shear"]),
               cell("%+.4f", rise(d, m, "shear")), cell("%.4f", m["stretch"]),
               cell("%+.4f", rise(d, m, "stretch")), count_cell(m["kernel_insertions"]),
               count_cell(m["retries"]), count_cell(m["flips"])});
  }
  return table.text();
}

// The direct method has rate 0.
inline std::string rates_csv(const std::vector<Task>& tasks, const std::vector<Measurement>& results)
{
  std::string text = "rate,seconds,shear,stretch\n";
  for(std::size_t i = 0; i < tasks.size(); ++i) {
    if(results[i].succeeded()) {
      text += format_number("%g", i == 0 ? 0 : 100 * tasks[i].rate);
      for(const char* name : {"seconds", "shear", "stretch"}) {
        text += format_number(",%.6g", results[i][name]);
      }
      text += "\n";
    }
  }
  return text;
}

// Two diagrams beside each other, like the paper's Fig. 7: shear and stretch against the rate
inline std::string rates_plot(const std::string& csv, const std::vector<Task>& tasks,
                              const Measurement& direct)
{
  double low = 100, high = 0;
  for(std::size_t i = 1; i < tasks.size(); ++i) {
    low = (std::min)(low, 100 * tasks[i].rate);
    high = (std::max)(high, 100 * tasks[i].rate);
  }
  const std::string data = "'" + csv + "' using 1:(column(1) > 0 ? ";
  std::string script =
      "set datafile separator ','\nset multiplot layout 1,2\nset xlabel 'simplification rate, %'\n"
      "set grid\nset key below\nset offsets 0, 0, graph 0.1, graph 0.1\n" +
      format_number("set xrange [%g:", low - 1) + format_number("%g]\n", high + 1);
  for(const auto& [name, column] : {std::make_pair("shear", "3"), std::make_pair("stretch", "4")}) {
    script += std::string("set ylabel 'L2 ") + name + "'\nplot " + data + "column(" + column +
              ") : 1/0) with linespoints pointtype 7 title 'hierarchical ABF++'";
    if(direct.succeeded()) {
      script += format_number(", %.9g with lines dashtype 2 title 'direct ABF++'", direct[name]);
    }
    script += "\n";
  }
  return script + "unset multiplot\n";
}

// Returns what the report says of the files.
inline std::string write_figure(const std::string& name, const std::vector<Task>& tasks,
                                const std::vector<Measurement>& results)
{
  write_file(name + ".csv", rates_csv(tasks, results));
  const std::string stem = name_of_file(name + ".csv");
  const std::string failure = plot(rates_plot(name + ".csv", tasks, results.front()), name + ".svg");
  return "\nThe same is in `" + stem + ".csv`, " +
         (failure.empty() ? "drawn in `" + stem + ".svg`.\n" : "but there is no figure: " + failure + ".\n");
}

} // namespace internal

inline std::string rates_part(const Command_line& command)
{
  const std::vector<Task> tasks = internal::rate_tasks(command);
  const std::vector<Measurement> results = Runner(command).run(tasks);
  std::string text =
      "The hierarchical method on " + name_of_file(command.mesh) +
      " with `Hierarchical_options::simplification_rate` varied, and the direct one; the rises are "
      "to the latter. The paper has 0.004 of shear and 0.025 of stretch at 95 %.\n\n" +
      internal::rates_table(tasks, results);
  if(!command.figure.empty()) {
    text += internal::write_figure(command.figure, tasks, results);
  }
  return text;
}

} // namespace hierarchical

#endif // HIERARCHICAL_RATES_H
