// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_NEXT_TEXTURE_H
#define FLATTEN_MESH_NEXT_TEXTURE_H

#include "flatten_mesh/Json.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace flatten_mesh {

// The names of vertex attributes with texture coordinates
inline const std::string texture_key = "TEXCOORD_";

inline bool is_texture_key(const std::string& key)
{
  return key.size() > texture_key.size() && key.size() < texture_key.size() + 5 &&
         key.compare(0, texture_key.size(), texture_key) == 0 &&
         std::all_of(key.begin() + texture_key.size(), key.end(),
                     [](const char c) { return c >= '0' && c <= '9'; });
}

// Texture coordinates make room for the new ones, which become the set number `set`.
inline int next_set(const int number, const int set)
{
  return number < set ? number : number + 1;
}

inline std::string next_key(const std::string& key, const int set)
{
  return is_texture_key(key)
             ? texture_key + std::to_string(next_set(std::stoi(key.substr(texture_key.size())), set))
             : key;
}

inline bool has_moved_keys(const tinygltf::Primitive& primitive, const int set)
{
  return std::any_of(primitive.attributes.begin(), primitive.attributes.end(), [set](const auto& attribute) {
    return next_key(attribute.first, set) != attribute.first;
  });
}

// Textures that a material names, wherever they are
inline void use_next_texture(Json& part, const int set)
{
  if(!part.is_structured()) {
    return;
  }
  for(const auto& [key, member] : part.items()) {
    if(key != "extras") {
      use_next_texture(member, set);
    }
  }
  if(part.is_object() && (part.contains("index") || part.contains("texCoord"))) {
    const auto before = part.find("texCoord");
    part["texCoord"] =
        next_set(before != part.end() && before->is_number_integer() ? before->get<int>() : 0, set);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_NEXT_TEXTURE_H
