// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_NEXT_TEXTURE_H
#define FLATTEN_MESH_NEXT_TEXTURE_H

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

// Textures that extensions name, wherever they are
inline void use_next_texture(tinygltf::Value& value, const int set)
{
  if(value.IsArray()) {
    for(tinygltf::Value& item : value.Get<tinygltf::Value::Array>()) {
      use_next_texture(item, set);
    }
  } else if(value.IsObject()) {
    auto& object = value.Get<tinygltf::Value::Object>();
    for(auto& [key, item] : object) {
      use_next_texture(item, set);
    }
    if(object.count("index") != 0 || object.count("texCoord") != 0) {
      const int before = object.count("texCoord") != 0 ? object["texCoord"].GetNumberAsInt() : 0;
      object["texCoord"] = tinygltf::Value(next_set(before, set));
    }
  }
}

inline void use_next_texture(tinygltf::ExtensionMap& extensions, const int set)
{
  for(auto& [name, value] : extensions) {
    use_next_texture(value, set);
  }
}

template <class Info>
void use_next_texture_of(Info& info, const int set)
{
  info.texCoord = next_set(info.texCoord, set);
  use_next_texture(info.extensions, set);
}

inline void use_next_texture(tinygltf::Material& material, const int set)
{
  use_next_texture_of(material.pbrMetallicRoughness.baseColorTexture, set);
  use_next_texture_of(material.pbrMetallicRoughness.metallicRoughnessTexture, set);
  use_next_texture_of(material.normalTexture, set);
  use_next_texture_of(material.occlusionTexture, set);
  use_next_texture_of(material.emissiveTexture, set);
  use_next_texture(material.extensions, set);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_NEXT_TEXTURE_H
