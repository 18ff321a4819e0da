// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ANGLE_BASED_FLATTENING_TEMPORARY_FOLDER_H
#define ANGLE_BASED_FLATTENING_TEMPORARY_FOLDER_H

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include <unistd.h>

// A folder of a test's own, with files, which are gone when the test ends.
struct Temporary_folder
{
  explicit Temporary_folder(const std::string& test)
      : path(std::filesystem::temp_directory_path() / (test + "_" + std::to_string(::getpid())))
  {
    std::filesystem::remove_all(path);
    std::filesystem::create_directory(path);
  }

  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }

  std::string file(const std::string& name) const { return (path / name).string(); }

  std::string write(const std::string& name, const std::string& text) const
  {
    std::ofstream(path / name, std::ios::binary) << text;
    return file(name);
  }

  std::string content(const std::string& name) const
  {
    std::ifstream stream(path / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }

  std::filesystem::path path;
};

#endif // ANGLE_BASED_FLATTENING_TEMPORARY_FOLDER_H
