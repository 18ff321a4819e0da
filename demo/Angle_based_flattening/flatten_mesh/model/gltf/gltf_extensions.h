// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_EXTENSIONS_H
#define FLATTEN_MESH_GLTF_EXTENSIONS_H

#include "flatten_mesh/model/gltf/Gltf_file.h"

#include <tiny_gltf.h>

#include <boost/algorithm/string/join.hpp>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Whether the triangles are what they seem without knowing the extension, and it stays right when they are replaced:
// it names neither accessors nor buffer views.
inline bool is_known_extension(const std::string& name)
{
  static const std::array<const char*, 8> beginnings = {
      "KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_",
      "KHR_lights_",    "KHR_xmp",      "KHR_node_",    "KHR_mesh_quantization"};
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&name](const std::string& beginning) { return name.rfind(beginning, 0) == 0; });
}

// Extensions without which the surface would be wrong also where they are not required
inline bool changes_surface(const std::string& name)
{
  static const std::array<const char*, 4> names = {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                                   "KHR_meshopt_compression", "EXT_mesh_gpu_instancing"};
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Owner>
void remove_extensions(Owner& owner, std::set<std::string>& removed)
{
  for(auto i = owner.extensions.begin(); i != owner.extensions.end();) {
    if(is_known_extension(i->first)) {
      ++i;
    } else {
      removed.insert(i->first);
      i = owner.extensions.erase(i);
    }
  }
}

template <class Owner>
void remove_extensions_of_all(std::vector<Owner>& owners, std::set<std::string>& removed)
{
  for(Owner& owner : owners) {
    remove_extensions(owner, removed);
  }
}

inline void remove_unknown_extensions(tinygltf::Model& model, std::set<std::string>& removed)
{
  remove_extensions(model, removed);
  remove_extensions_of_all(model.materials, removed);
  remove_extensions_of_all(model.textures, removed);
  remove_extensions_of_all(model.images, removed);
  remove_extensions_of_all(model.nodes, removed);
  remove_extensions_of_all(model.scenes, removed);
  remove_extensions_of_all(model.skins, removed);
  remove_extensions_of_all(model.cameras, removed);
  remove_extensions_of_all(model.animations, removed);
  remove_extensions_of_all(model.meshes, removed);
  for(tinygltf::Mesh& mesh : model.meshes) {
    remove_extensions_of_all(mesh.primitives, removed);
  }
}

// Throws if the surface cannot be understood without an extension that is not known. Removes other such extensions.
inline void check_extensions(Gltf_file& file, std::vector<std::string>& remarks)
{
  tinygltf::Model& model = file.model;
  for(const auto* names : {&model.extensionsRequired, &model.extensionsUsed}) {
    for(const std::string& name : *names) {
      if(changes_surface(name) || (names == &model.extensionsRequired && !is_known_extension(name))) {
        refuse_gltf(file.name, "it needs the glTF extension " + name + ", which is not read" +
                                   (name.find("compression") != name.npos
                                        ? ": decompress the file first, or export without compression"
                                        : ""));
      }
    }
  }
  std::set<std::string> removed;
  remove_unknown_extensions(model, removed);
  for(const std::string& name : removed) {
    if(changes_surface(name)) {
      refuse_gltf(file.name, "it uses the glTF extension " + name + ", which is not read");
    }
  }
  auto& used = model.extensionsUsed;
  used.erase(std::remove_if(used.begin(), used.end(),
                            [](const std::string& name) { return !is_known_extension(name); }),
             used.end());
  if(!removed.empty()) {
    remarks.push_back("extensions of glTF that are not known are left out: " +
                      boost::algorithm::join(removed, ", "));
  }
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_EXTENSIONS_H
