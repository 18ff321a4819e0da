// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OUTPUT_FILE_H
#define FLATTEN_MESH_OUTPUT_FILE_H

#include "texts.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace flatten_mesh {

// A file that appears under its name only when it is complete. The text goes into a temporary file next to
// the target, which `publish()` renames, and which vanishes with the object otherwise. Devices and pipes are
// written directly.
class Output_file
{
public:
  explicit Output_file(const std::string& name) : m_name(name)
  {
    std::error_code ignored;
    const std::filesystem::path target = std::filesystem::weakly_canonical(name, ignored);
    if(std::filesystem::is_directory(target, ignored)) {
      throw Input_error("cannot write '" + name + "': it is a folder; give the name of a file");
    }
    m_target = target.empty() ? std::filesystem::path(name) : target;
    const bool renamed =
        !std::filesystem::exists(m_target, ignored) || std::filesystem::is_regular_file(m_target, ignored);
    m_temporary = m_target;
    if(renamed) {
      m_temporary += ".unfinished";
    }
    m_stream.open(m_temporary, std::ios::binary);
    if(!m_stream) {
      fail();
    }
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file()
  {
    m_stream.close();
    if(m_temporary != m_target) {
      std::error_code ignored;
      std::filesystem::remove(m_temporary, ignored);
    }
  }

  // Throws unless `name` can be written now. Nothing is left behind.
  static void check(const std::string& name)
  {
    if(!name.empty()) {
      Output_file trial(name);
    }
  }

  void write(const std::string& text)
  {
    m_stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    m_stream.flush();
    if(!m_stream) {
      fail();
    }
  }

  void publish()
  {
    m_stream.close();
    if(!m_stream) {
      fail();
    }
    if(m_temporary != m_target) {
      std::error_code error;
      std::filesystem::rename(m_temporary, m_target, error);
      if(error) {
        fail();
      }
    }
  }

private:
  [[noreturn]] void fail() const
  {
    throw Input_error("cannot write '" + m_name +
                      "': check that its folder exists, may be written to, and that the disk is not full");
  }

  std::string m_name;
  std::filesystem::path m_target;
  std::filesystem::path m_temporary;
  std::ofstream m_stream;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OUTPUT_FILE_H
