// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_STANDARD_INPUT_FILE_H
#define FLATTEN_MESH_STANDARD_INPUT_FILE_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Unfinished_files.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>
#include <string>

#include <unistd.h>

namespace flatten_mesh {

// A copy of standard input, as a file whose name tells its format. It lasts as long as the object.
class Standard_input_file
{
public:
  // Makes the copy if the command reads standard input, and lets it read that instead.
  explicit Standard_input_file(Command_line& command)
  {
    if(command.input != standard_input) {
      return;
    }
    m_name = (std::filesystem::temp_directory_path() /
              ("flatten_mesh." + std::to_string(::getpid()) + "." + std::to_string(std::random_device()()) +
               "." + command.format))
                 .string();
    Unfinished_files::add(m_name.c_str());
    std::ofstream file(m_name, std::ios::binary);
    if(std::cin.peek() != std::char_traits<char>::eof()) { // inserting nothing would count as a failure
      file << std::cin.rdbuf();
    }
    file.close();
    if(!file) {
      remove();
      throw Output_error("cannot keep a copy of standard input in '" + m_name +
                         "': check that the disk is not full");
    }
    command.input = m_name;
  }

  Standard_input_file(const Standard_input_file&) = delete;
  Standard_input_file& operator=(const Standard_input_file&) = delete;

  ~Standard_input_file() { remove(); }

private:
  void remove()
  {
    if(!m_name.empty()) {
      std::error_code ignored;
      std::filesystem::remove(m_name, ignored);
      Unfinished_files::remove(m_name.c_str());
    }
  }

  std::string m_name; // empty if there is none
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_STANDARD_INPUT_FILE_H
