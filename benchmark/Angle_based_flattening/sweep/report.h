// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SWEEP_REPORT_H
#define SWEEP_REPORT_H

#include "Run.h"

#include "../common/format.h"

#include <CGAL/Surface_mesh_parameterization/Error_code.h>

#include <map>
#include <string>
#include <vector>

namespace sweep {

using namespace benchmarks;

inline std::string table_head()
{
  return markdown_head(
      {"file", "component", "triangles", "borders", "holes", "result", "injective", "seconds", "message"}, 1);
}

inline std::string escaped(const std::string& text)
{
  std::string result;
  for(const char c : text) {
    result += c == '|' ? "\\|" : std::string(1, c);
  }
  return result;
}

// (CGAL's own function for that gives other texts for some codes.)
inline std::string name_of_code(const int code)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  switch(code) {
  case SMP::OK:
    return "OK";
  case SMP::ERROR_EMPTY_MESH:
    return "ERROR_EMPTY_MESH";
  case SMP::ERROR_NON_TRIANGULAR_MESH:
    return "ERROR_NON_TRIANGULAR_MESH";
  case SMP::ERROR_NO_TOPOLOGICAL_DISC:
    return "ERROR_NO_TOPOLOGICAL_DISC";
  case SMP::ERROR_CANNOT_SOLVE_LINEAR_SYSTEM:
    return "ERROR_CANNOT_SOLVE_LINEAR_SYSTEM";
  case SMP::ERROR_NO_1_TO_1_MAPPING:
    return "ERROR_NO_1_TO_1_MAPPING";
  case SMP::ERROR_WRONG_PARAMETER:
    return "ERROR_WRONG_PARAMETER";
  default:
    return "error " + std::to_string(code);
  }
}

inline std::string result_cell(const Run& run)
{
  if(!run.fault.empty()) {
    return "**FAULT: " + escaped(run.fault) + "**";
  }
  return run.is_valid() ? "valid" : name_of_code(run.code);
}

inline std::string table_rows(const File_results& results)
{
  std::string text;
  if(!results.unreadable.empty()) {
    text += markdown_row({results.file, "", "", "", "", "not read", "", "", escaped(results.unreadable)});
  }
  if(!results.fault.empty()) {
    text +=
        markdown_row({results.file, "", "", "", "", "**FAULT: " + escaped(results.fault) + "**", "", "", ""});
  }
  for(const Run& run : results.runs) {
    text += markdown_row({results.file, std::to_string(run.component), std::to_string(run.triangles),
                          std::to_string(run.borders), run.allow_holes ? "allowed" : "", result_cell(run),
                          run.is_valid() ? (run.injective ? "yes" : "no") : "", format_seconds(run.seconds),
                          escaped(run.message)});
  }
  return text;
}

struct Summary
{
  long files = 0, unreadable = 0, closed = 0, runs = 0, valid = 0, injective = 0;
  std::map<std::string, long> errors;
  std::vector<std::string> faults;

  void add(const File_results& results)
  {
    ++files;
    unreadable += !results.unreadable.empty();
    closed += results.closed;
    if(!results.fault.empty()) {
      faults.push_back(results.file + ": " + results.fault);
    }
    for(const Run& run : results.runs) {
      ++runs;
      valid += run.is_valid();
      injective += run.injective;
      if(!run.fault.empty()) {
        faults.push_back(results.file + ", component " + std::to_string(run.component) +
                         (run.allow_holes ? ", holes allowed: " : ": ") + run.fault);
      } else if(!run.is_valid()) {
        ++errors[name_of_code(run.code)];
      }
    }
  }

  std::string text() const
  {
    std::string text = std::to_string(files) + " files, of which " + std::to_string(unreadable) +
                       " were not read; " + std::to_string(closed) + " closed components were skipped. " +
                       std::to_string(runs) + " runs: " + std::to_string(valid) + " valid, of which " +
                       std::to_string(injective) + " injective as a whole.\n\n";
    for(const auto& [name, number] : errors) {
      text += "* " + name + ": " + std::to_string(number) + "\n";
    }
    text += errors.empty() ? "" : "\n";
    if(faults.empty()) {
      return text + "No crash, no timeout, no map that was called valid and is not.\n";
    }
    text += "**" + std::to_string(faults.size()) + " FAULTS:**\n\n";
    for(const std::string& fault : faults) {
      text += "* " + fault + "\n";
    }
    return text;
  }
};

} // namespace sweep

#endif // SWEEP_REPORT_H
