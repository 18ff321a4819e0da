// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_MESH_FILES_H
#define BENCHMARKS_COMMON_MESH_FILES_H

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace benchmarks {

// The meshes in a folder, by their names, sorted; with `std::filesystem::recursive_directory_iterator` also those in
// folders within it.
template <class Directory_iterator = std::filesystem::directory_iterator>
std::vector<std::filesystem::path> mesh_files(const std::string& folder)
{
  const std::set<std::string> extensions{".off", ".obj", ".ply", ".stl"};
  std::vector<std::filesystem::path> files;
  for(const auto& entry : Directory_iterator(folder)) {
    if(entry.is_regular_file() && extensions.count(entry.path().extension().string())) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_MESH_FILES_H
