// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_RUNNER_H
#define COMPARE_RUNNER_H

#include "Command_line.h"
#include "Results.h"
#include "Test_mesh.h"

#include "../common/Temporary_folder.h"
#include "../common/measure_in_child.h"

#include <cstddef>
#include <iostream>
#include <map>
#include <string>
#include <vector>

namespace compare {

// Measures mesh by mesh, each method in processes of its own.
class Runner
{
public:
  Runner(const Command_line& command, const std::vector<Method_title>& methods)
      : m_command(command), m_methods(methods)
  {}

  // A method that was stopped on two meshes is not tried on larger ones.
  Mesh_results run(const Test_mesh& mesh)
  {
    const Temporary_folder folder;
    const std::string file =
        mesh.resized() ? write_resized_mesh(m_command, mesh.triangles, folder.file("")) : mesh.file;
    std::map<std::string, std::vector<Measurement>> runs;
    for(int repetition = 0; repetition < m_command.repeat; ++repetition) {
      for(const Method_title& method : m_methods) {
        std::vector<Measurement>& done = runs[method.name];
        if(done.empty() && m_stops[method.name] >= 2) {
          done.push_back(failed_measurement("not tried"));
        } else if(is_worth_repeating(done)) {
          done.push_back(run_once(mesh, method, file));
        }
      }
    }
    Mesh_results results = {mesh.name, mesh.resized(), mesh.triangles, {}};
    for(const auto& [method, measurements] : runs) {
      Measurement& result = results.measurements[method] = median(measurements);
      result.numbers["runs"] = static_cast<double>(measurements.size());
      if(result.succeeded()) {
        results.triangles = static_cast<std::size_t>(result["triangles"]);
      }
    }
    return results;
  }

private:
  bool is_worth_repeating(const std::vector<Measurement>& done) const
  {
    double seconds = 0;
    for(const Measurement& measurement : done) {
      if(!measurement.succeeded()) {
        return false;
      }
      seconds += measurement["seconds"];
    }
    return seconds < m_command.limits.seconds;
  }

  Measurement run_once(const Test_mesh& mesh, const Method_title& method, const std::string& file)
  {
    Measurement measurement = measure_in_child(
        {"--run", method.name, "--file", file, "--threads", std::to_string(m_command.threads)},
        m_command.limits);
    if(measurement.failure.rfind("took longer", 0) == 0 || measurement.failure == "out of memory") {
      measurement.failure = "stopped: " + measurement.failure;
      ++m_stops[method.name];
    }
    std::cerr << mesh.name << ", " << mesh.triangles << ", " << method.name << ": "
              << outcome_text(measurement, measurement["seconds"]) << std::endl;
    return measurement;
  }

  const Command_line& m_command;
  std::vector<Method_title> m_methods;
  std::map<std::string, int> m_stops;
};

} // namespace compare

#endif // COMPARE_RUNNER_H
