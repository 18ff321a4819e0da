// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_RUNNER_H
#define HIERARCHICAL_RUNNER_H

#include "Command_line.h"
#include "Task.h"
#include "measure.h"

#include "../common/Measurement.h"
#include "../common/measure_in_child.h"

#include <cstddef>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace hierarchical {

inline std::string name_of_file(const std::string& file)
{
  return std::filesystem::path(file).stem().string();
}

// Measures each task in processes of its own.
class Runner
{
public:
  explicit Runner(const Command_line& command) : m_command(command) {}

  // Task by task, and then all of them again, so that a disturbance does not hit one task only. The results are
  // medians. What failed once is not tried again.
  std::vector<Measurement> run(const std::vector<Task>& tasks) const
  {
    std::vector<std::vector<Measurement>> runs(tasks.size());
    for(int repetition = 0; repetition < m_command.repeat; ++repetition) {
      for(std::size_t i = 0; i < tasks.size(); ++i) {
        if(runs[i].empty() || runs[i].back().succeeded()) {
          runs[i].push_back(run_once(tasks[i]));
        }
      }
    }
    std::vector<Measurement> medians;
    for(const std::vector<Measurement>& measurements : runs) {
      medians.push_back(median(measurements));
    }
    return medians;
  }

private:
  Measurement run_once(const Task& task) const
  {
    const Measurement measurement = measure_in_child(arguments(task), m_command.limits);
    std::cerr << name_of_file(task.file) << ", " << title(task.method) << ", threads " << task.threads
              << ", rate " << task.rate << ", sweeps " << task.sweeps << ": "
              << outcome_text(measurement, measurement["seconds"]) << std::endl;
    return measurement;
  }

  const Command_line& m_command;
};

} // namespace hierarchical

#endif // HIERARCHICAL_RUNNER_H
