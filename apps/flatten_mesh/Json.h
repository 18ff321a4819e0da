// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_JSON_H
#define FLATTEN_MESH_JSON_H

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace flatten_mesh {

// Members stay in their order. Numbers that are not finite are written as `null`.
using Json = nlohmann::ordered_json;

namespace internal {

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

// JSON for an element of a page: `<` might end it.
inline std::string json_for_html(const Json& json)
{
  std::string text;
  for(const char c : json_text(json)) {
    text += c == '<' ? "\\u003c" : std::string(1, c);
  }
  return text;
}

} // namespace internal

// A report for programs, as it is written to its file
inline std::string json_report_text(const Json& report)
{
  return internal::json_text(report, 2) + "\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_JSON_H
