// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_TEMPORARY_FOLDER_H
#define BENCHMARKS_COMMON_TEMPORARY_FOLDER_H

#include <stdlib.h> // mkdtemp() is not in the namespace std

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace benchmarks {

// A folder that vanishes with the object.
class Temporary_folder
{
public:
  Temporary_folder() : m_path((std::filesystem::temp_directory_path() / "abf_benchmark_XXXXXX").string())
  {
    if(mkdtemp(&m_path[0]) == nullptr) {
      throw std::runtime_error("cannot make a temporary folder");
    }
  }

  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  std::string file(const std::string& name) const { return m_path + "/" + name; }

private:
  std::string m_path;
};

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_TEMPORARY_FOLDER_H
