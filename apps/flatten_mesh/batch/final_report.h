// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FINAL_REPORT_H
#define FLATTEN_MESH_FINAL_REPORT_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/batch/add_run.h"
#include "flatten_mesh/batch/read_report.h"
#include "flatten_mesh/file_names.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Whether a report is newer than all files that it depends on
inline bool is_newer(const std::string& report, const Command_line& command)
{
  std::vector<std::string> files = command.input.empty() ? command.inputs : std::vector{command.input};
  for(const std::string& file :
      {command.atlas.bake_from, command.atlas.seams_from, command.cut, command.border_angles}) {
    if(std::error_code ignored; !file.empty() && std::filesystem::is_regular_file(file, ignored)) {
      files.push_back(file);
    }
  }
  std::error_code error;
  const auto written = std::filesystem::last_write_time(report, error);
  return !error && std::all_of(files.begin(), files.end(), [&](const std::string& file) {
    const auto changed = std::filesystem::last_write_time(file, error);
    return !error && changed < written;
  });
}

} // namespace internal

// The exit status of an earlier run of the same version with the same options on the same input, if it is final: what
// ran out of time or memory, crashed or could not be written may succeed the next time.
inline std::optional<Exit_status> final_status(const Command_line& command)
{
  std::error_code ignored;
  if(!std::filesystem::is_regular_file(command.json, ignored) || !internal::is_newer(command.json, command)) {
    return std::nullopt;
  }
  const std::optional<Json> report = read_report(command.json);
  if(!report) {
    return std::nullopt;
  }
  // Bytes that are no UTF-8 change when they are written.
  Json expected;
  internal::add_run(expected, SUCCESS, command.batch.recorded);
  expected = Json::parse(internal::json_text(expected));
  const std::array<std::string, 4> passing = {"TIMED_OUT", "OUT_OF_MEMORY", "CRASHED", "CANNOT_WRITE"};
  const bool is_final =
      report->value("version", Json()) == expected["version"] &&
      report->value("options", Json()) == expected["options"] &&
      std::find(passing.begin(), passing.end(), report->at("status").get<std::string>()) == passing.end();
  return is_final ? std::optional(static_cast<Exit_status>(report->at("exit_status").get<int>()))
                  : std::nullopt;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FINAL_REPORT_H
