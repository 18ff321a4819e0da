// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FILE_CONTENT_H
#define FLATTEN_MESH_FILE_CONTENT_H

#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

namespace flatten_mesh {

namespace internal {

inline void check_file_is_there(const std::string& name)
{
  std::error_code ignored;
  if(name == standard_input) {
    return;
  }
  if(!std::filesystem::exists(name, ignored)) {
    throw Input_error("there is no file '" + name + "': check its name and folder");
  }
  if(std::filesystem::is_directory(name, ignored)) {
    throw Input_error("'" + name + "' is a folder: name a mesh file");
  }
  if(std::filesystem::is_character_file(name, ignored) || std::filesystem::is_block_file(name, ignored)) {
    throw Input_error("'" + name + "' is a device: name a mesh file");
  }
}

// All at once, and only once: pipes cannot be read twice.
inline std::string bytes_of_file(const std::string& name)
{
  if(name == standard_input) {
    return std::string(std::istreambuf_iterator<char>(std::cin), {});
  }
  std::ifstream file(name, std::ios::binary);
  if(!file) {
    throw Input_error("'" + name + "' cannot be read: check its permissions");
  }
  std::string bytes;
  std::error_code ignored;
  if(std::filesystem::is_regular_file(name, ignored)) {
    bytes.resize(std::filesystem::file_size(name));
    file.read(&bytes[0], static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(file.gcount()));
    file.clear();
  }
  bytes.append(std::istreambuf_iterator<char>(file), {});
  return bytes;
}

} // namespace internal

// Of a file that is there. Throws an `Input_error` if it cannot be read or is empty. "-" is standard input.
inline std::string content_of_file(const std::string& name)
{
  std::string content = internal::bytes_of_file(name);
  if(content.empty()) {
    throw Input_error("'" + name + "' is empty: export the mesh again");
  }
  return content;
}

// Some programs write a byte order mark at the start of text files.
inline std::string_view without_byte_order_mark(std::string_view content)
{
  const std::string_view mark = "\xEF\xBB\xBF";
  content.remove_prefix(content.substr(0, mark.size()) == mark ? mark.size() : 0);
  return content;
}

// The format that a file seems to have, or an empty string. For a message about a file that contradicts its name
inline std::string kind_of_content(const std::string_view content)
{
  const auto begins = [content](const std::string_view word) {
    return content.substr(0, word.size()) == word;
  };
  return begins("ply\n") || begins("ply\r")                  ? "PLY"
         : begins("OFF") || begins("COFF") || begins("NOFF") ? "OFF"
         : begins("solid ")                                  ? "STL"
         : begins("GOCAD")                                   ? "TS"
         : begins("glTF")                                    ? "GLB"
         : begins("\x1F\x8B") || begins("PK\x03\x04")        ? "compressed"
         : begins("\xFF\xFE") || begins("\xFE\xFF")          ? "UTF-16"
         : begins("<")                                       ? "XML"
                                                             : "";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FILE_CONTENT_H
