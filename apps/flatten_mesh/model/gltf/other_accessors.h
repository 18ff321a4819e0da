// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OTHER_ACCESSORS_H
#define FLATTEN_MESH_OTHER_ACCESSORS_H

#include "flatten_mesh/model/gltf/Gltf_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

// Calls `f(number, text)` with the number of each accessor whose elements have nothing to do with vertices, and what it
// is used for: those of skins, animations and instances. `Json_type` is `Json` or `const Json`.
template <class Json_type, class Function>
void for_each_other_accessor(const Gltf_file& file, Json_type& json, const Function& f)
{
  const auto call = [&](Json_type& parent, const std::string& key, const std::string& text) {
    if(number_in(file, parent, key, text) >= 0) {
      f(*parent.find(key), text);
    }
  };
  const auto number_text = [](const std::string& noun, const std::size_t i) {
    return noun + " " + std::to_string(i);
  };
  const std::vector<Json_type*> skins = objects_in(file, json, "skins"),
                                animations = objects_in(file, json, "animations"),
                                nodes = objects_in(file, json, "nodes");
  for(std::size_t i = 0; i < skins.size(); ++i) {
    call(*skins[i], "inverseBindMatrices", number_text("skin", i));
  }
  for(std::size_t i = 0; i < animations.size(); ++i) {
    for(Json_type* const sampler : objects_in(file, *animations[i], "samplers")) {
      call(*sampler, "input", number_text("animation", i));
      call(*sampler, "output", number_text("animation", i));
    }
  }
  for(std::size_t i = 0; i < nodes.size(); ++i) {
    const auto extensions = nodes[i]->find("extensions");
    if(extensions == nodes[i]->end() || !extensions->is_object()) {
      continue;
    }
    for(const auto& [name, extension] : extensions->items()) {
      const auto attributes = extension.find("attributes");
      if(name == "EXT_mesh_gpu_instancing" && attributes != extension.end() && attributes->is_object()) {
        for(const auto& [key, number] : attributes->items()) {
          call(*attributes, key, number_text("node", i));
        }
      }
    }
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OTHER_ACCESSORS_H
