// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RUN_RECORD_H
#define FLATTEN_MESH_RUN_RECORD_H

#include "Flattening.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

// Everything that the reports for people and for programs tell.
struct Run_record
{
  std::string input;
  std::size_t vertices = 0; // of the chart, as are the next two
  std::size_t triangles = 0;
  std::size_t borders = 0;
  std::size_t components = 0; // of the whole mesh
  double read_seconds = 0;
  double write_seconds = 0;
  Flattening flattening;
  std::vector<std::string> written;
};

// The name of a diagnosis, "OK" for none.
inline std::string status_name(const SMP::ABF_plus_plus_report& report)
{
  using Report = SMP::ABF_plus_plus_report;
  switch(report.diagnosis) {
  case Report::NOTHING_WRONG:
    return report.status == SMP::OK ? "OK" : "FAILED";
  case Report::EMPTY_MESH:
    return "EMPTY_MESH";
  case Report::NOT_ON_BORDER:
    return "NOT_ON_BORDER";
  case Report::NOT_TRIANGULATED:
    return "NOT_TRIANGULATED";
  case Report::NON_FINITE_POINT:
    return "NON_FINITE_POINT";
  case Report::TOO_LARGE:
    return "TOO_LARGE";
  case Report::PINCHED_VERTEX:
    return "PINCHED_VERTEX";
  case Report::SEVERAL_BORDERS:
    return "SEVERAL_BORDERS";
  case Report::HANDLES:
    return "HANDLES";
  case Report::PARALLEL_EDGES:
    return "PARALLEL_EDGES";
  case Report::LINEAR_SYSTEM_FAILED:
    return "LINEAR_SYSTEM_FAILED";
  case Report::NO_CONVERGENCE:
    return "NO_CONVERGENCE";
  case Report::WRONG_OPTION:
    return "WRONG_OPTION";
  case Report::WRONG_LAYOUT:
    return "WRONG_LAYOUT";
  case Report::FLIPPED_TRIANGLES:
    return "FLIPPED_TRIANGLES";
  case Report::PRECISION_EXCEEDED:
    return "PRECISION_EXCEEDED";
  case Report::CANCELLED:
    return "CANCELLED";
  }
  return "FAILED";
}

inline std::string rung_name(const SMP::ABF_plus_plus_report::Rung rung)
{
  using Report = SMP::ABF_plus_plus_report;
  switch(rung) {
  case Report::FROM_TARGET_ANGLES:
    return "from target angles";
  case Report::RAISED_BARRIER:
    return "raised barrier";
  case Report::FROM_VALID_MAP:
    return "from a valid map";
  default:
    return "valid map";
  }
}

inline std::string layout_name(const SMP::ABF_plus_plus_report& report)
{
  using Report = SMP::ABF_plus_plus_report;
  return report.layout == Report::EXACT           ? "exact"
         : report.layout == Report::LEAST_SQUARES ? "least-squares"
                                                  : "none";
}

// Whether the computation failed, and not the input.
inline bool is_failure_of_computation(const SMP::ABF_plus_plus_report& report)
{
  using Report = SMP::ABF_plus_plus_report;
  switch(report.diagnosis) {
  case Report::NOTHING_WRONG:
  case Report::LINEAR_SYSTEM_FAILED:
  case Report::NO_CONVERGENCE:
  case Report::WRONG_LAYOUT:
  case Report::FLIPPED_TRIANGLES:
  case Report::PRECISION_EXCEEDED:
    return true;
  default:
    return false;
  }
}

// The stages, with the time of each. The chart's reading and writing are `chart` and `uv`; files have `read`
// and `write`. `parameterize` is the whole call of the parameterizer, so the sum of its stages.
inline std::vector<std::pair<std::string, double>> seconds_of_stages(const Run_record& record)
{
  std::vector<std::pair<std::string, double>> result{{"read", record.read_seconds}};
  result.insert(result.end(), record.flattening.stages.begin(), record.flattening.stages.end());
  result.emplace_back("parameterize", record.flattening.parameterize_seconds);
  result.emplace_back("measure", record.flattening.measure_seconds);
  result.emplace_back("write", record.write_seconds);
  return result;
}

// The largest memory that this process took until the map was there, in megabytes; 0 where unknown.
inline double peak_memory_mb(const SMP::ABF_plus_plus_report& report)
{
  return static_cast<double>(report.peak_memory) / (1024. * 1024.);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RUN_RECORD_H
