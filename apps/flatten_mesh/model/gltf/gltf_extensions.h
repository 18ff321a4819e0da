// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_EXTENSIONS_H
#define FLATTEN_MESH_GLTF_EXTENSIONS_H

#include "flatten_mesh/model/gltf/Gltf_file.h"

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Whether the triangles are what they seem without knowing the extension, and it stays right when they are replaced:
// it names no buffer views, and accessors only where `for_each_other_accessor()` finds them.
inline bool is_known_extension(const std::string& name)
{
  static const std::array<const char*, 11> beginnings = {"KHR_materials_",
                                                         "KHR_texture_",
                                                         "EXT_texture_",
                                                         "MSFT_texture_",
                                                         "KHR_lights_",
                                                         "KHR_xmp",
                                                         "KHR_node_",
                                                         "KHR_mesh_quantization",
                                                         "KHR_animation_",
                                                         "KHR_mesh_primitive_",
                                                         "EXT_mesh_gpu_instancing"};
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&name](const std::string& beginning) { return name.rfind(beginning, 0) == 0; });
}

// Extensions without which the surface would be wrong also where they are not required
constexpr std::array<const char*, 3> extensions_of_surfaces = {
    "KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"};

inline bool changes_surface(const std::string& name)
{
  return std::find(extensions_of_surfaces.begin(), extensions_of_surfaces.end(), name) !=
         extensions_of_surfaces.end();
}

[[noreturn]] inline void refuse_extension(const std::string& file, const std::string& name)
{
  refuse_gltf(file, "it needs the glTF extension " + name + ", which is not read" +
                        (name.find("compression") != name.npos
                             ? ": decompress the file first, or export without compression"
                             : ""));
}

// Removes extensions that are not known from a part of the description and all its parts.
inline void remove_unknown_extensions(Json& part, std::set<std::string>& removed)
{
  if(part.is_array()) {
    for(Json& element : part) {
      remove_unknown_extensions(element, removed);
    }
  } else if(part.is_object()) {
    if(const auto found = part.find("extensions"); found != part.end() && found->is_object()) {
      Json known = Json::object();
      for(const auto& [name, extension] : found->items()) {
        if(is_known_extension(name)) {
          known[name] = extension;
        } else {
          removed.insert(name);
        }
      }
      *found = known;
      if(known.empty()) {
        part.erase("extensions");
      }
    }
    for(const auto& [key, member] : part.items()) {
      if(key != "extras") { // of which nothing is known
        remove_unknown_extensions(member, removed);
      }
    }
  }
}

// Throws if the surface cannot be understood without an extension that is not known. Removes other such extensions.
inline void check_extensions(Gltf_file& file, std::vector<std::string>& remarks)
{
  for(const char* const list : {"extensionsRequired", "extensionsUsed"}) {
    const auto names = file.json.find(list);
    if(names == file.json.end()) {
      continue;
    }
    Json known = Json::array();
    for(const Json& name : *names) {
      if(!name.is_string()) {
        refuse_gltf(file.name, std::string("'") + list + "' is not a list of names");
      }
      if(is_known_extension(name)) {
        known.push_back(name);
      } else if(changes_surface(name) || list == std::string("extensionsRequired")) {
        refuse_extension(file.name, name);
      }
    }
    *names = known;
    if(known.empty()) {
      file.json.erase(list);
    }
  }
  std::set<std::string> removed;
  remove_unknown_extensions(file.json, removed);
  for(const std::string& name : removed) {
    if(changes_surface(name)) {
      refuse_extension(file.name, name);
    }
  }
  if(!removed.empty()) {
    remarks.push_back("extensions of glTF that are not known are left out: " +
                      boost::algorithm::join(removed, ", "));
  }
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_EXTENSIONS_H
