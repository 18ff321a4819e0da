// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_JSON_JSON_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_JSON_JSON_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace CGAL::Texture_atlas::internal {

using Json = nlohmann::ordered_json;

template <class Value>
Json json_optional(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json();
}

// The JSON of each value, by a function
template <class Values, class Function>
Json json_array(const Values& values, const Function& json_of)
{
  Json array = Json::array();
  for(const auto& value : values) {
    array.push_back(json_of(value));
  }
  return array;
}

// Bytes that are no UTF-8, as names of files may have, become the replacement character U+FFFD.
inline std::string json_text(const Json& json, const int indentation = -1)
{
  return json.dump(indentation, ' ', false, Json::error_handler_t::replace);
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_JSON_JSON_H
