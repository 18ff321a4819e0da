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
  const auto number = [](const Json& json, const std::string& place, const double otherwise) {
    const auto found = Json::json_pointer(place);
    return json.contains(found) && json[found].is_number() ? json[found].get<double>() : otherwise;
  };
  if(number(transform, "/texCoord", number(texture, "/texCoord", 0)) != 0) {
    return;
  }
  const double angle = number(transform, "/rotation", 0), c = std::cos(angle), s = std::sin(angle),
               u_scale = number(transform, "/scale/0", 1), v_scale = number(transform, "/scale/1", 1),
               u_offset = number(transform, "/offset/0", 0), v_offset = number(transform, "/offset/1", 0);
  for(std::size_t i = 0; i < uv.size(); i += 2) {
    const double u = u_scale * uv[i], v = v_scale * uv[i + 1];
    uv[i] = c * u - s * v + u_offset;
    uv[i + 1] = s * u + c * v + v_offset;
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TEXTURE_TRANSFORM_H
