// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OUTPUT_FILE_H
#define FLATTEN_MESH_OUTPUT_FILE_H

#include "flatten_mesh/Unfinished_file.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <system_error>

#include <unistd.h>

namespace flatten_mesh {

// A file that appears under its name only when it is complete. The text is written to a temporary file next to the
// target, which `publish()` renames. Otherwise the temporary file is removed with the object or at the end of the
// process. Standard output, devices and pipes are written directly.
class Output_file
{
public:
  explicit Output_file(const std::string& name) : m_name(name)
  {
    if(name == standard_output) {
      return;
    }
    check_target();
    if(is_replaced() && !m_unfinished.create(m_target)) {
      fail();
    }
    m_stream.open(m_unfinished.exists() ? std::filesystem::path(m_unfinished.name()) : m_target,
                  std::ios::binary);
    if(!m_stream) {
      m_unfinished.remove();
      fail();
    }
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  // Throws unless `name` can be written now. Leaves nothing behind. Does not open pipes and devices: closing them
  // would signal the end to their reader.
  static void check(const std::string& name)
  {
    std::error_code ignored;
    const std::filesystem::path target = resolved(name);
    if(!name.empty() && (!std::filesystem::exists(target, ignored) || !is_other_file(target))) {
      Output_file trial(name);
    }
  }

  void write(const std::string& text)
  {
    std::ostream& stream = m_name == standard_output ? std::cout : m_stream;
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.flush();
    if(!stream) {
      fail();
    }
  }

  void publish()
  {
    if(m_stream.is_open()) {
      m_stream.close();
    }
    if(!m_stream) {
      fail();
    }
    if(m_unfinished.exists() && !m_unfinished.rename(m_target)) {
      fail();
    }
  }

  // Empty for standard output
  const std::filesystem::path& target() const { return m_target; }

private:
  void check_target()
  {
    std::error_code ignored;
    m_target = resolved(m_name);
    if(std::filesystem::is_directory(m_target, ignored)) {
      throw Output_error("cannot write '" + m_name + "': it is a folder; give the name of a file");
    }
    // Renaming ignores the permissions of the existing file, and the superuser may write every file.
    using Permissions = std::filesystem::perms;
    const Permissions write = Permissions::owner_write | Permissions::group_write | Permissions::others_write;
    if(std::filesystem::exists(m_target, ignored) &&
       ((std::filesystem::status(m_target, ignored).permissions() & write) == Permissions::none ||
        ::access(m_target.c_str(), W_OK) != 0)) {
      throw Output_error("cannot write '" + m_name +
                         "': the file exists and is read-only; choose another name or make it writable");
    }
  }

  bool is_replaced() const
  {
    std::error_code ignored;
    return !std::filesystem::exists(m_target, ignored) || !is_other_file(m_target);
  }

  [[noreturn]] void fail() const
  {
    if(m_name == standard_output) {
      throw Output_error(
          "cannot write to standard output: check that the disk is not full and the pipe is not closed");
    }
    throw Output_error("cannot write '" + m_name +
                       "': check that its folder exists and is writable, and that the disk is not full");
  }

  std::string m_name;
  std::filesystem::path m_target;
  Unfinished_file m_unfinished; // does not exist where the target is written directly
  std::ofstream m_stream;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OUTPUT_FILE_H
