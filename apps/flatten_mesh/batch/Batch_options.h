// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BATCH_OPTIONS_H
#define FLATTEN_MESH_BATCH_OPTIONS_H

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace flatten_mesh {

// How many inputs are run, and within which bounds
struct Batch_options
{
  std::string list; // a file with further inputs, or empty
  bool is_null_separated = false;
  std::string shard;                   // "I/N", or empty
  std::string output_folder;           // or empty; otherwise:
  std::filesystem::path common_folder; // of all inputs
  int jobs = 1;
  bool resumes = false;
  double timeout = std::numeric_limits<double>::infinity(); // in seconds
  std::string memory;                                       // as given, or empty
  std::size_t memory_bytes = 0;                             // 0: no bound
  std::string summary;                                      // a folder with reports, or empty
  std::vector<std::string> recorded; // the options that results depend on, for the report for programs

  bool has_bounds() const { return timeout < std::numeric_limits<double>::infinity() || memory_bytes > 0; }
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BATCH_OPTIONS_H
