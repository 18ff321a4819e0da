// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SUMMARIZE_REPORTS_H
#define FLATTEN_MESH_SUMMARIZE_REPORTS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Exit_status.h"
#include "flatten_mesh/Output_files.h"
#include "flatten_mesh/batch/Reports_summary.h"
#include "flatten_mesh/batch/summary_page.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iostream>
#include <map>
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

// A line of a table (RFC 4180)
inline std::string csv_line(const Reports_summary::Row& values)
{
  std::string line;
  for(const std::string& value : values) {
    line += line.empty() ? "" : ",";
    line += value.find_first_of(",\"\r\n") == std::string::npos
                ? value
                : '"' + boost::replace_all_copy(value, "\"", "\"\"") + '"';
  }
  return line + "\n";
}

inline std::string summary_table(const Reports_summary& summary)
{
  const auto& columns = summary_columns();
  Reports_summary::Row names;
  std::transform(columns.begin(), columns.end(), names.begin(),
                 [](const Summary_column& column) { return column.name; });
  std::string table = csv_line(names);
  for(const Reports_summary::Row& row : summary.rows) {
    table += csv_line(row);
  }
  return table;
}

// "998 OK, 2 TIMED_OUT", the most frequent first
inline std::string text_of_statuses(const Reports_summary& summary)
{
  std::map<std::string, std::size_t> numbers;
  for(const Reports_summary::Row& row : summary.rows) {
    ++numbers[row[2]];
  }
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

// Writes a table or a page with a row for each report for programs below a folder, and on standard error how many have
// each status.
inline Exit_status summarize_reports(const Command_line& command)
{
  const std::string& folder = command.batch.summary;
  Reports_summary summary;
  for(const std::filesystem::path& file : internal::report_files(folder)) {
    const std::string name = file.lexically_relative(folder).replace_extension().string();
    const std::size_t number = summary.left_out.size();
    add_report(name, file.string(), summary);
    if(summary.left_out.size() > number && !command.quiet) {
      std::cerr << "flatten_mesh: note: " << in_one_line("'" + file.string() + "'")
                << " is no report of this program, and left out" << std::endl;
    }
  }
  if(summary.rows.empty()) {
    throw Input_error("--summary '" + folder + "': below this folder is no report of this program");
  }
  Output_files files;
  if(!command.report.empty()) {
    files.open(command.report).write(summary_page(folder, summary));
  }
  if(!command.output.empty() || command.report.empty()) {
    files.open(command.output.empty() ? standard_output : command.output)
        .write(internal::summary_table(summary));
  }
  files.publish();
  if(!command.quiet) {
    std::cerr << "flatten_mesh: " << count_text(summary.rows.size(), "report") << ": "
              << in_one_line(internal::text_of_statuses(summary)) << std::endl;
  }
  return SUCCESS;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SUMMARIZE_REPORTS_H
