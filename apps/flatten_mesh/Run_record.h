// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RUN_RECORD_H
#define FLATTEN_MESH_RUN_RECORD_H

#include "flatten_mesh/batch/Batch_options.h"
#include "flatten_mesh/batch/add_run.h"
#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/Json.h"
#include "flatten_mesh/report_rows.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>

#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace SMP = CGAL::Surface_mesh_parameterization;

// What reports say of a run of the program, whatever it makes
struct Run_record
{
  std::string input;
  double read_seconds = 0;
  double write_seconds = 0;
  double peak_memory_mb = 0; // 0 if unknown
  std::vector<std::string> written;
  std::vector<std::string> notes;
};

using Stages = std::vector<std::pair<std::string, double>>; // with the seconds of each

// Whether a computation failed, rather than that the input cannot be flattened
inline bool is_failure_of_computation(const SMP::Diagnosis status)
{
  return status == SMP::Diagnosis::LINEAR_SYSTEM_FAILED || status == SMP::Diagnosis::NO_CONVERGENCE ||
         status == SMP::Diagnosis::FLIPPED_TRIANGLES || status == SMP::Diagnosis::COARSE_CHART_FAILED ||
         status == SMP::Diagnosis::OVERLAPPING;
}

namespace internal {

// The first members of the report for programs
inline Json run_json(const Run_record& record, const std::string& status, const std::string& message,
                     const Exit_status exit_status, const Batch_options& batch)
{
  Json json = {{"status", status}, {"message", message}, {"notes", record.notes}, {"input", record.input}};
  add_run(json, exit_status, batch.recorded);
  return json;
}

// Its last members
inline void add_end_of_run(Json& json, const Run_record& record, const Stages& stages)
{
  for(const auto& [stage, seconds] : stages) {
    json["seconds"][stage] = seconds;
  }
  json["peak_memory_mb"] = record.peak_memory_mb > 0 ? Json(record.peak_memory_mb) : Json();
}

// The last rows of the report for people. `hint` says how to get files.
inline Report_rows run_rows(const Run_record& record, const Report_rows& stages, const std::string& hint)
{
  Report_rows rows = {{"seconds"}};
  append(rows, stages);
  if(record.peak_memory_mb > 0) {
    rows.push_back({"peak memory", format_number("%.0f MB", record.peak_memory_mb)});
  }
  for(const std::string& name : record.written) {
    rows.push_back({"written", name});
  }
  if(record.written.empty()) {
    rows.push_back({"written", "nothing", hint});
  }
  return rows;
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RUN_RECORD_H
