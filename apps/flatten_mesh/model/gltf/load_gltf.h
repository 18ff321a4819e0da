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
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The lengths that a binary file promises
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

// The parts of a file
struct Gltf_parts
{
  std::string_view description;
  std::optional<std::string_view> binary;
};

inline Gltf_parts parts_of_gltf(const std::string_view content, const bool is_binary, const std::string& name)
{
  if(!is_binary) {
    return {content, std::nullopt};
  }
  check_glb(content, name);
  std::uint32_t total = 0, json_length = 0, length = 0, type = 0;
  Binary_data bytes(content.substr(8), boost::endian::order::little);
  bytes.read(total);
  bytes.read(json_length);
  bytes.skip(4 + static_cast<std::size_t>(json_length));
  Gltf_parts parts{content.substr(20, json_length), std::nullopt};
  const std::size_t begin = std::size_t(28) + json_length;
  if(begin <= total && bytes.read(length) && bytes.read(type) && type == 0x004E4942) {
    parts.binary = content.substr(begin, length);
  }
  return parts;
}

inline Json parse_description(const std::string_view text, const std::string& name)
{
  check_depth(text, name);
  try {
    Json json = Json::parse(text.substr(0, text.find_last_not_of('\0') + 1));
    if(!json.is_object()) {
      refuse_gltf(name, "its description is no JSON object");
    }
    return json;
  } catch(const Json::parse_error& error) {
    refuse_gltf(name, "its description is no JSON: byte " + std::to_string(error.byte) + " does not fit");
  } catch(const Json::exception&) {
    refuse_gltf(name, "its description has a number that is too large");
  }
}

// What tinygltf is to read. It refuses some animations and skins that are right, and changes numbers of other parts.
inline tinygltf::Model surface_of_description(const Json& json, const std::string& name)
{
  Json surface = Json::object();
  for(const char* const key :
      {"asset", "scene", "scenes", "nodes", "meshes", "materials", "accessors", "bufferViews"}) {
    if(const auto part = json.find(key); part != json.end()) {
      surface[key] = *part;
    }
  }
  const std::string text = surface.dump();
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error, warning;
  bool is_loaded = false;
  try {
    is_loaded = loader.LoadASCIIFromString(&model, &error, &warning, text.data(),
                                           static_cast<unsigned>(text.size()), "");
  } catch(const std::exception& exception) {
    error = exception.what();
  }
  if(!is_loaded || !error.empty()) { // what could not be understood may have been left out without failure
    refuse_gltf(name, error.empty() ? "it is damaged" : gltf_problem(error));
  }
  if(model.asset.version.compare(0, 2, "2.") != 0) {
    refuse_gltf(name, "it is glTF of version '" + in_one_line(model.asset.version) + "', and 2.0 is read");
  }
  return model;
}

// Only the first buffer can be the binary part of the file.
inline void read_buffers(Gltf_file& file, const std::optional<std::string_view> binary)
{
  const std::vector<Json*> buffers = objects_in(file, file.json, "buffers");
  for(std::size_t i = 0; i < buffers.size(); ++i) {
    const std::string text = "buffer " + std::to_string(i), uri = text_in(*buffers[i], "uri");
    const auto length = buffers[i]->find("byteLength");
    if(length == buffers[i]->end() || !length->is_number_unsigned()) {
      refuse_gltf(file.name, text + " does not say how long it is");
    }
    std::vector<unsigned char> bytes;
    if(uri.empty() && i == 0 && binary) {
      bytes.assign(binary->begin(), binary->end());
    } else if(!read_uri(file, uri, bytes)) {
      refuse_gltf(file.name,
                  text + (uri.empty()    ? " names no file"
                          : is_data(uri) ? " is no data"
                                         : " cannot be read: there is no file '" + in_one_line(uri) + "'"));
    }
    const auto promised = length->get<std::size_t>();
    if(promised > bytes.size()) {
      refuse_gltf(file.name, text + " has " + count_text(bytes.size(), "byte") + " instead of " +
                                 std::to_string(promised));
    }
    bytes.resize(promised);
    file.bytes.push_back(std::move(bytes));
  }
}

// Each node gets a mesh of its own. What is wrong with the meshes is told later.
inline void separate_instances(const Gltf_file& file, Json& json)
{
  const std::size_t meshes = objects_in(file, json, "meshes").size();
  std::vector<bool> is_used(meshes, false);
  for(Json* const node : objects_in(file, json, "nodes")) {
    const int mesh = number_in(file, *node, "mesh", "a node");
    if(mesh < 0 || static_cast<std::size_t>(mesh) >= meshes) {
      continue;
    }
    if(is_used[static_cast<std::size_t>(mesh)]) {
      (*node)["mesh"] = json["meshes"].size();
      const Json copy = json["meshes"][static_cast<std::size_t>(mesh)];
      json["meshes"].push_back(copy);
    }
    is_used[static_cast<std::size_t>(mesh)] = true;
  }
}

} // namespace internal

// A glTF file without extensions that are not known. Those are told in `remarks`, and pictures that are not there.
inline Gltf_file load_gltf(const std::string_view content, const bool is_binary, const std::string& name,
                           const bool unique_instances, std::vector<std::string>& remarks)
{
  const internal::Gltf_parts parts = internal::parts_of_gltf(content, is_binary, name);
  Gltf_file file;
  file.name = name;
  file.json = internal::parse_description(parts.description, name);
  internal::check_extensions(file, remarks);
  if(unique_instances) {
    internal::separate_instances(file, file.json);
  }
  file.model = internal::surface_of_description(file.json, name);
  internal::read_buffers(file, parts.binary);
  internal::take_pictures(file, remarks);
  return file;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_LOAD_GLTF_H
