// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_TASK_H
#define HIERARCHICAL_TASK_H

#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>

#include <sstream>
#include <string>
#include <vector>

namespace hierarchical {

// What one process measures.
struct Task
{
  std::string method; // the name of one of `all_methods()`
  std::string file;   // of the mesh
  int threads = 1;
  double rate = CGAL::Surface_mesh_parameterization::Hierarchical_options().simplification_rate;
  int sweeps = CGAL::Surface_mesh_parameterization::Hierarchical_options().sweeps;

  Task() = default;
  Task(const std::string& method, const std::string& file, const int threads = 1)
      : method(method), file(file), threads(threads)
  {}
};

// The arguments that give the task to a process of this program
inline std::vector<std::string> arguments(const Task& task)
{
  std::ostringstream rate;
  rate << task.rate;
  return {"--measure",     task.method,
          "--file",        task.file,
          "--on-cores",    std::to_string(task.threads),
          "--rate",        rate.str(),
          "--with-sweeps", std::to_string(task.sweeps)};
}

} // namespace hierarchical

#endif // HIERARCHICAL_TASK_H
