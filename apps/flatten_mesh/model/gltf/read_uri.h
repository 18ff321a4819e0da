// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_URI_H
#define FLATTEN_MESH_READ_URI_H

#include "flatten_mesh/model/gltf/Gltf_file.h"

#include <tiny_gltf.h>

#include <charconv>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

namespace internal {

// A member of a part of the description that is a text, or an empty one
inline std::string text_in(const Json& part, const char* const key)
{
  const auto text = part.find(key);
  return text != part.end() && text->is_string() ? text->get<std::string>() : "";
}

// Whether a URI has the data in itself
inline bool is_data(const std::string& uri)
{
  return uri.compare(0, 5, "data:") == 0;
}

// A name in which `%20` stands for a space, and so on. What does not stand for anything stays.
inline std::string without_percent_codes(const std::string& uri)
{
  std::string name;
  for(std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char code = 0;
    const char* const begin = uri.data() + i + 1;
    if(uri[i] == '%' && i + 2 < uri.size() && std::from_chars(begin, begin + 2, code, 16).ptr == begin + 2) {
      name += static_cast<char>(code);
      i += 2;
    } else {
      name += uri[i];
    }
  }
  return name;
}

// The file that a URI names, or an empty name. All names begin in the folder of the model. They are the name that the
// URI stands for, or the URI itself, which some programs write. Devices, which may have no end, are no files.
inline std::filesystem::path file_beside(const std::string& model, const std::string& uri)
{
  for(const std::string& name : {without_percent_codes(uri), uri}) {
    const std::filesystem::path path = std::filesystem::absolute(model).parent_path() / ("./" + name);
    std::error_code ignored;
    if(!uri.empty() && name.find('\0') == name.npos && std::filesystem::is_regular_file(path, ignored)) {
      return path.lexically_normal();
    }
  }
  return {};
}

// Reads what a URI names, or has in itself. Returns whether that was possible.
inline bool read_uri(Gltf_file& file, const std::string& uri, std::vector<unsigned char>& bytes)
{
  if(is_data(uri)) {
    std::string type;
    return tinygltf::DecodeDataURI(&bytes, type, uri, 0, false);
  }
  const std::filesystem::path path = file_beside(file.name, uri);
  std::ifstream stream(path, std::ios::binary);
  if(path.empty() || !stream) {
    return false;
  }
  bytes.assign(std::istreambuf_iterator<char>(stream), {});
  file.files_beside.push_back(path.string());
  return true;
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_URI_H
