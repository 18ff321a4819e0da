// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXTURE_TRANSFORM_H
#define FLATTEN_MESH_TEXTURE_TRANSFORM_H

#include "flatten_mesh/model/gltf/Gltf_file.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

// Applies KHR_texture_transform to the first texture coordinates: what a material shows of its color texture is scaled,
// rotated and moved by them. `material` is a number, or -1.
inline void apply_texture_transform(const Gltf_file& file, const int material, std::vector<double>& uv)
{
  const auto pointer =
      Json::json_pointer("/materials/" + std::to_string(material) + "/pbrMetallicRoughness/baseColorTexture");
  if(material < 0 || !file.json.contains(pointer)) {
    return;
  }
  const Json& texture = file.json[pointer];
  const auto transform_pointer = Json::json_pointer("/extensions/KHR_texture_transform");
  if(!texture.contains(transform_pointer)) {
    return;
  }
  const Json& transform = texture[transform_pointer];
  const auto number = [](const Json* const json, const double otherwise) {
    return json != nullptr && json->is_number() ? json->get<double>() : otherwise;
  };
  const auto member = [](const Json& json, const char* const key) -> const Json* {
    const auto place = json.find(key);
    return place == json.end() ? nullptr : &*place;
  };
  const auto pair_member = [&](const char* const key, const std::size_t i) -> const Json* {
    const Json* const pair = member(transform, key);
    return pair != nullptr && pair->is_array() && pair->size() == 2 ? &(*pair)[i] : nullptr;
  };
  if(number(member(transform, "texCoord"), number(member(texture, "texCoord"), 0)) != 0) {
    return;
  }
  const double a = number(member(transform, "rotation"), 0), c = std::cos(a), s = std::sin(a);
  for(std::size_t i = 0; i < uv.size(); i += 2) {
    const double u = number(pair_member("scale", 0), 1) * uv[i],
                 v = number(pair_member("scale", 1), 1) * uv[i + 1];
    uv[i] = c * u - s * v + number(pair_member("offset", 0), 0);
    uv[i + 1] = s * u + c * v + number(pair_member("offset", 1), 0);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TEXTURE_TRANSFORM_H
