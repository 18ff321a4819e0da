// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SUMMARIZE_REPORTS_H
#define FLATTEN_MESH_SUMMARIZE_REPORTS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/batch/read_report.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The files below a folder whose names end with '.json', in the order of their names
inline std::vector<std::filesystem::path> report_files(const std::string& folder)
{
  std::vector<std::filesystem::path> files;
  std::error_code error;
  using Iterator = std::filesystem::recursive_directory_iterator;
  for(Iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    if(std::error_code ignored; file_format(i->path().string()) == "json" && i->is_regular_file(ignored)) {
      files.push_back(i->path());
    }
  }
  if(error) {
    throw Input_error("cannot read the folder '" + folder + "' of --summary: " + error.message());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// A value of a table (RFC 4180)
inline std::string csv_text(const std::string& text)
{
  return text.find_first_of(",\"\r\n") == std::string::npos
             ? text
             : '"' + boost::replace_all_copy(text, "\"", "\"\"") + '"';
}

// Of all stages. With `--plain`, `parameterize` is the sum of some of them.
inline std::string seconds_of(const Report_tree& report)
{
  static const std::set<std::string> of_plain = {"read",    "seams", "parameterize",
                                                 "measure", "split", "write"};
  const Report_tree stages = report.get_child("seconds", Report_tree());
  const bool is_plain = stages.count("parameterize") != 0;
  double seconds = 0;
  for(const auto& [name, value] : stages) {
    seconds += is_plain && of_plain.count(name) == 0 ? 0 : value.get_value<double>(0);
  }
  return stages.empty() ? "" : format_number("%.3f", seconds);
}

inline const char* summary_header()
{
  return "name,input,status,exit_status,message,triangles,charts,covered,stretch,seam,seconds,peak_memory_"
         "mb\n";
}

// Values that a report does not have are empty.
inline std::string summary_row(const std::string& name, const Report_tree& report)
{
  const auto value = [&report](const std::string& key, const std::string& key_of_plain) {
    const std::string text = report.get<std::string>(key, report.get<std::string>(key_of_plain, "null"));
    return text == "null" ? "" : csv_text(text);
  };
  const auto text = [&value](const std::string& key) { return value(key, key); };
  const auto charts = report.get_child_optional("atlas.charts");
  const bool is_one_chart = !charts && report.count("method") != 0;
  std::string row = csv_text(name);
  for(const std::string& column :
      {text("input"), text("status"), text("exit_status"), text("message"), text("triangles"),
       charts         ? std::to_string(charts->size())
       : is_one_chart ? std::string("1")
                      : std::string(),
       text("atlas.packing.covered_share"), value("atlas.l2_stretch", "l2_stretch"),
       value("atlas.seams.relative_length", "seams.length"), seconds_of(report), text("peak_memory_mb")}) {
    row += "," + column;
  }
  return row + "\n";
}

// "998 OK, 2 TIMED_OUT", the most frequent first
inline std::string text_of_counts(const std::map<std::string, std::size_t>& numbers)
{
  std::vector<std::pair<std::string, std::size_t>> sorted(numbers.begin(), numbers.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  std::string text;
  for(const auto& [status, number] : sorted) {
    text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + status;
  }
  return text;
}

} // namespace internal

// Writes a table with a row for each report for programs below a folder, and on standard error how many have each
// status.
inline Exit_status summarize_reports(const Command_line& command)
{
  const std::string& folder = command.batch.summary;
  std::string table = internal::summary_header();
  std::map<std::string, std::size_t> numbers;
  std::size_t reports = 0;
  for(const std::filesystem::path& file : internal::report_files(folder)) {
    if(const std::optional<Report_tree> report = read_report(file.string())) {
      table += internal::summary_row(file.lexically_relative(folder).replace_extension().string(), *report);
      ++numbers[report->get<std::string>("status")];
      ++reports;
    } else if(!command.quiet) {
      std::cerr << "flatten_mesh: note: " << in_one_line("'" + file.string() + "'")
                << " is no report of this program, and left out" << std::endl;
    }
  }
  if(reports == 0) {
    throw Input_error("--summary '" + folder + "': below this folder is no report of this program");
  }
  Output_file file(command.output.empty() ? standard_output : command.output);
  file.write(table);
  file.publish();
  if(!command.quiet) {
    std::cerr << "flatten_mesh: " << count_text(reports, "report") << ": "
              << internal::text_of_counts(numbers) << std::endl;
  }
  return SUCCESS;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SUMMARIZE_REPORTS_H
