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

// Texture coordinates make room for the new ones.
inline std::string next_key(const std::string& key)
{
  return texture_key + std::to_string(std::stoi(key.substr(texture_key.size())) + 1);
}

inline bool has_texture_keys(const tinygltf::Primitive& primitive)
{
  return std::any_of(primitive.attributes.begin(), primitive.attributes.end(),
                     [](const auto& attribute) { return is_texture_key(attribute.first); });
}

// Textures that extensions name, wherever they are
inline void use_next_texture(tinygltf::Value& value)
{
  if(value.IsArray()) {
    for(tinygltf::Value& item : value.Get<tinygltf::Value::Array>()) {
      use_next_texture(item);
    }
  } else if(value.IsObject()) {
    auto& object = value.Get<tinygltf::Value::Object>();
    for(auto& [key, item] : object) {
      use_next_texture(item);
    }
    if(object.count("index") != 0 || object.count("texCoord") != 0) {
      const int before = object.count("texCoord") != 0 ? object["texCoord"].GetNumberAsInt() : 0;
      object["texCoord"] = tinygltf::Value(before + 1);
    }
  }
}

inline void use_next_texture(tinygltf::ExtensionMap& extensions)
{
  for(auto& [name, value] : extensions) {
    use_next_texture(value);
  }
}

template <class Info>
void use_next_texture_of(Info& info)
{
  ++info.texCoord;
  use_next_texture(info.extensions);
}

inline void use_next_texture(tinygltf::Material& material)
{
  use_next_texture_of(material.pbrMetallicRoughness.baseColorTexture);
  use_next_texture_of(material.pbrMetallicRoughness.metallicRoughnessTexture);
  use_next_texture_of(material.normalTexture);
  use_next_texture_of(material.occlusionTexture);
  use_next_texture_of(material.emissiveTexture);
  use_next_texture(material.extensions);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_NEXT_TEXTURE_H
