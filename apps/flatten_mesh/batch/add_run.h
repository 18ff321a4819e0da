// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ADD_RUN_H
#define FLATTEN_MESH_ADD_RUN_H

#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/Json.h"

#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// What `--resume` and `--summary` ask the report for programs
inline void add_run(Json& json, const Exit_status status, const std::vector<std::string>& options)
{
  json["exit_status"] = static_cast<int>(status);
  json["version"] = ABF_VERSION;
  json["options"] = options;
}

} // namespace internal

// The report for programs of a failure outside of the parameterizer
inline std::string failure_json(const std::string& status, const Exit_status exit_status,
                                const std::string& message, const std::string& input,
                                const std::vector<std::string>& options)
{
  Json json = {{"status", status}, {"message", message}, {"input", input}};
  internal::add_run(json, exit_status, options);
  return json_report_text(json);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_ADD_RUN_H
