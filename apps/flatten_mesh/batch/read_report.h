// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_REPORT_H
#define FLATTEN_MESH_READ_REPORT_H

#include "flatten_mesh/Json.h"

#include <fstream>
#include <optional>
#include <string>
#include <utility>

namespace flatten_mesh {

// A report for programs, if the file is one
inline std::optional<Json> read_report(const std::string& file)
{
  std::ifstream input(file, std::ios::binary);
  Json report = Json::parse(input, nullptr, false);
  const auto is_text = [&](const char* key) { return report.contains(key) && report[key].is_string(); };
  const bool is_report = is_text("status") && report["status"] != "" && is_text("input") &&
                         report.contains("exit_status") && report["exit_status"].is_number_integer();
  return is_report ? std::optional(std::move(report)) : std::nullopt;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_REPORT_H
