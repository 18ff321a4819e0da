// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_EXPLAIN_UNREADABLE_FILE_H
#define FLATTEN_MESH_EXPLAIN_UNREADABLE_FILE_H

#include "Input_error.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

namespace flatten_mesh {

inline void check_file_is_there(const std::string& name)
{
  std::error_code ignored;
  if(!std::filesystem::exists(name, ignored)) {
    throw Input_error("there is no file '" + name + "': check its name and folder");
  }
  if(std::filesystem::is_directory(name, ignored)) {
    throw Input_error("'" + name + "' is a folder: name a mesh file");
  }
  if(!std::ifstream(name)) {
    throw Input_error("'" + name + "' may not be read: check its permissions");
  }
  if(std::filesystem::is_regular_file(name, ignored) && std::filesystem::file_size(name, ignored) == 0) {
    throw Input_error("'" + name + "' is empty: export the mesh again");
  }
}

namespace internal {

// Whether a word is a number that is none, as programs write it.
inline bool is_not_a_finite_number(std::string word)
{
  boost::algorithm::to_lower(word);
  boost::algorithm::trim_if(word, [](const char c) { return c == '+' || c == '-'; });
  return word == "nan" || word == "-nan" || word == "nan(ind)" || word == "-nan(ind)" || word == "inf" ||
         word == "infinity" || word == "1.#qnan" || word == "1.#ind" || word == "1.#inf";
}

} // namespace internal

// One line about a file that CGAL could not read. Standard C++ streams do not read "nan" and "inf", so that
// in text files these are found here.
inline std::string explain_unreadable_file(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  std::string line;
  for(std::size_t number = 1; std::getline(file, line) && line.find('\0') == std::string::npos; ++number) {
    std::istringstream words(line);
    std::string word;
    while(words >> word && word[0] != '#') {
      if(internal::is_not_a_finite_number(word)) {
        return "'" + name + "', line " + std::to_string(number) + ": the coordinate '" + word +
               "' is not a finite number; remove the vertex or repair the scan";
      }
    }
  }
  return "cannot read '" + name +
         "': it is damaged, cut short, has a face with a vertex that is not there, or is not in the format "
         "that its name says; export the mesh again";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_EXPLAIN_UNREADABLE_FILE_H
