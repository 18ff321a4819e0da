// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ADD_RUN_H
#define FLATTEN_MESH_ADD_RUN_H

#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/json.h"

#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// What `--resume` and `--summary` ask the report for programs
inline void add_run(Json_object& json, const Exit_status status, const std::vector<std::string>& options)
{
  json.add("exit_status", json_number(static_cast<int>(status)));
  json.add("version", json_text(ABF_VERSION));
  json.add("options", json_texts(options));
}

} // namespace internal

// The report for programs of a failure outside of the parameterizer
inline std::string failure_json(const std::string& status, const Exit_status exit_status,
                                const std::string& message, const std::string& input,
                                const std::vector<std::string>& options)
{
  internal::Json_object json;
  json.add("status", internal::json_text(status));
  json.add("message", internal::json_text(message));
  json.add("input", internal::json_text(input));
  internal::add_run(json, exit_status, options);
  return json.text() + "\n";
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_ADD_RUN_H
