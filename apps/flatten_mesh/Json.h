// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_JSON_H
#define FLATTEN_MESH_JSON_H

#include <CGAL/Texture_atlas/internal/json/report_json.h>

#include <string>

namespace flatten_mesh {

using CGAL::Texture_atlas::internal::Json;

namespace internal {

using CGAL::Texture_atlas::internal::json_array;
using CGAL::Texture_atlas::internal::json_optional;
using CGAL::Texture_atlas::internal::json_text;

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
