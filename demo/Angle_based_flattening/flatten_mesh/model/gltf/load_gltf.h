// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_LOAD_GLTF_H
#define FLATTEN_MESH_LOAD_GLTF_H

#include "flatten_mesh/model/Binary_data.h"
#include "flatten_mesh/model/gltf/Gltf_file.h"
#include "flatten_mesh/model/gltf/gltf_extensions.h"
#include "flatten_mesh/model/gltf/gltf_pictures.h"
#include "flatten_mesh/texts.h"

#include <tiny_gltf.h>

#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

struct Files_beside
{
  std::string folder;
  std::vector<std::string> read;
};

// Files are looked for in the folder of the model only, and devices, which may have no end, are none.
inline bool is_file_beside(const std::string& name, void* const files)
{
  const std::string& folder = static_cast<const Files_beside*>(files)->folder;
  std::error_code ignored;
  return name.compare(0, folder.size(), folder) == 0 && std::filesystem::is_regular_file(name, ignored);
}

inline bool read_file_beside(std::vector<unsigned char>* const bytes, std::string* const error,
                             const std::string& name, void* const files)
{
  std::ifstream file(name, std::ios::binary);
  if(!file) {
    *error += "it cannot be read";
    return false;
  }
  bytes->assign(std::istreambuf_iterator<char>(file), {});
  static_cast<Files_beside*>(files)->read.push_back(name);
  return true;
}

inline bool size_of_file_beside(std::size_t* const size, std::string* const error, const std::string& name,
                                void*)
{
  std::error_code problem;
  *size = std::filesystem::file_size(name, problem);
  if(problem) {
    *error += "it cannot be read";
  }
  return !problem;
}

// From version 2.9 on, tinygltf asks for the sizes of files as well.
template <class Callbacks>
auto set_size_of_file(Callbacks& callbacks, int) -> decltype(callbacks.GetFileSizeInBytes, void())
{
  callbacks.GetFileSizeInBytes = &size_of_file_beside;
}

template <class Callbacks>
void set_size_of_file(Callbacks&, long)
{}

template <class Callbacks>
Callbacks callbacks_for(Files_beside& files)
{
  Callbacks callbacks{};
  callbacks.FileExists = &is_file_beside;
  callbacks.ExpandFilePath = [](const std::string& path, void*) { return path; };
  callbacks.ReadWholeFile = &read_file_beside;
  callbacks.WriteWholeFile = &tinygltf::WriteWholeFile;
  set_size_of_file(callbacks, 0);
  callbacks.user_data = &files;
  return callbacks;
}

// The lengths that a binary file promises. Tinygltf reads eight bytes more than there are.
inline void check_glb(const std::string_view content, const std::string& name)
{
  std::uint32_t magic = 0, version = 0, length = 0, json_length = 0, chunk_length = 0;
  Binary_data bytes(content, boost::endian::order::little);
  if(!bytes.read(magic) || magic != 0x46546C67 || !bytes.read(version) || !bytes.read(length) ||
     !bytes.read(json_length)) {
    refuse_gltf(name, content.size() < 16 ? "a GLB file has at least 20 bytes, so it was cut short"
                                          : "a GLB file begins with 'glTF'");
  }
  if(version != 2) {
    refuse_gltf(name, "it is binary glTF of version " + std::to_string(version) + ", and 2 is read");
  }
  if(length > content.size()) {
    refuse_gltf(name, "the header promises " + count_text(length, "byte") + ", but the file has only " +
                          std::to_string(content.size()) + ": it was cut short");
  }
  const std::uint64_t binary = std::uint64_t(20) + json_length;
  if(binary > length) {
    refuse_gltf(name, "its description has " + count_text(json_length, "byte") + ", more than the file");
  }
  bytes.skip(4 + static_cast<std::size_t>(json_length));
  if(binary < length && (!bytes.read(chunk_length) || binary + 8 + chunk_length > length)) {
    refuse_gltf(name, "its binary part has " + count_text(chunk_length, "byte") +
                          ", more than the file has room for");
  }
}

// Values that are nested deeply would take the stack of who goes through them.
inline void check_depth(const std::string_view json, const std::string& name)
{
  const int most = 500;
  int depth = 0;
  bool is_text = false;
  for(std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if(is_text) {
      i += c == '\\';
      is_text = c != '"';
    } else {
      is_text = c == '"';
      depth += (c == '{' || c == '[') - (c == '}' || c == ']');
    }
    if(depth > most) {
      refuse_gltf(name, "its description is nested more than " + std::to_string(most) + " times");
    }
  }
}

inline std::string gltf_problem(const std::string& text)
{
  const std::size_t longest = 300; // of data as texts
  return in_one_line(boost::algorithm::trim_copy_if(text.substr(0, longest), boost::is_any_of(" \n.")));
}

inline tinygltf::Model parse_gltf(const std::string_view content, const bool is_binary,
                                  const std::string& name, std::vector<std::string>& files_beside)
{
  const auto length = static_cast<unsigned>(content.size());
  if(content.size() > (std::numeric_limits<unsigned>::max)()) {
    refuse_gltf(name, "glTF files of more than 4 GB are not read");
  }
  if(is_binary) {
    check_glb(content, name);
    std::uint32_t json_length = 0;
    Binary_data bytes(content.substr(12), boost::endian::order::little);
    bytes.read(json_length);
    check_depth(content.substr(20, json_length), name);
  } else {
    check_depth(content, name);
  }
  Files_beside files{std::filesystem::absolute(name).parent_path().string(), {}};
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(callbacks_for<tinygltf::FsCallbacks>(files));
  loader.SetImageLoader(&keep_picture, nullptr);
  tinygltf::Model model;
  std::string error, warning; // about pictures, which are checked afterwards
  bool is_loaded = false;
  try {
    is_loaded =
        is_binary
            ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                          reinterpret_cast<const unsigned char*>(content.data()), length,
                                          files.folder)
            : loader.LoadASCIIFromString(&model, &error, &warning, content.data(), length, files.folder);
  } catch(const std::exception& exception) {
    error = exception.what();
  }
  if(!is_loaded || !error.empty()) { // what could not be understood may have been left out without failure
    refuse_gltf(name, error.empty() ? "it is damaged" : gltf_problem(error));
  }
  if(model.asset.version.compare(0, 2, "2.") != 0) {
    refuse_gltf(name, "it is glTF of version '" + model.asset.version + "', and 2.0 is read");
  }
  files_beside = std::move(files.read);
  return model;
}

} // namespace internal

// A glTF file, its pictures checked, without extensions that are not known. Those are told in `remarks`.
inline Gltf_file load_gltf(const std::string_view content, const bool is_binary, const std::string& name,
                           std::vector<std::string>& remarks)
{
  Gltf_file file;
  file.name = name;
  file.model = internal::parse_gltf(content, is_binary, name, file.files_beside);
  for(tinygltf::Buffer& buffer : file.model.buffers) {
    file.bytes.push_back(std::move(buffer.data));
  }
  file.model.buffers.clear();
  internal::check_extensions(file, remarks);
  internal::take_pictures(file);
  return file;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_LOAD_GLTF_H
