// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORTS_SUMMARY_H
#define FLATTEN_MESH_REPORTS_SUMMARY_H

#include "flatten_mesh/batch/read_report.h"
#include "flatten_mesh/model/text_numbers.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace flatten_mesh {

struct Summary_column
{
  std::string name;
  bool is_number;
};

inline const std::array<Summary_column, 13>& summary_columns()
{
  static const std::array<Summary_column, 13> columns = {{{"name", false},
                                                          {"input", false},
                                                          {"status", false},
                                                          {"exit_status", true},
                                                          {"message", false},
                                                          {"triangles", true},
                                                          {"charts", true},
                                                          {"covered", true},
                                                          {"density", true},
                                                          {"stretch", true},
                                                          {"seam", true},
                                                          {"seconds", true},
                                                          {"peak_memory_mb", true}}};
  return columns;
}

// A chart of one of many atlases
struct Summarized_chart
{
  std::size_t row; // that of its report
  std::size_t number;
  std::optional<double> triangles, share_of_area;
  std::string method;
  double l2_stretch; // may be infinite
};

// What many reports say
struct Reports_summary
{
  using Row = std::array<std::string, 13>; // as the columns; what a report does not have is empty

  std::vector<Row> rows;
  std::vector<Summarized_chart> worst; // the charts with the largest stretch, which are first
  std::vector<std::string> left_out;   // files that are no reports

  static constexpr std::size_t number_of_worst = 20;
};

namespace internal {

// A member, or `null`: "/atlas/charts" are the charts of the atlas.
inline const Json& member(const Json& json, const std::string& path)
{
  static const Json none;
  const Json::json_pointer pointer(path);
  return json.contains(pointer) ? json[pointer] : none;
}

inline std::string text_of_value(const Json& value)
{
  std::string text;
  if(value.is_number_float()) {
    append_number(text, value.get<double>());
  } else if(!value.is_null()) {
    text = value.is_string() ? value.get<std::string>() : json_text(value);
  }
  return text;
}

// Of all stages. With `--plain`, `parameterize` is the sum of some of them.
inline std::string seconds_of(const Json& report)
{
  static const std::set<std::string> of_plain = {"read",    "seams", "parameterize",
                                                 "measure", "split", "write"};
  const Json& stages = member(report, "/seconds");
  const bool is_plain = stages.contains("parameterize");
  double seconds = 0;
  for(const auto& [name, value] : stages.items()) {
    seconds += value.is_number() && (!is_plain || of_plain.count(name) != 0) ? value.get<double>() : 0;
  }
  return stages.empty() ? "" : format_number("%.3f", seconds);
}

inline std::string number_of_charts(const Json& report)
{
  const Json& charts = member(report, "/atlas/charts");
  return charts.is_array() ? std::to_string(charts.size()) : report.contains("method") ? "1" : "";
}

inline Reports_summary::Row row_of_report(const std::string& name, const Json& report)
{
  const auto value = [&report](const char* path, const char* path_of_plain = "") {
    const Json& found = member(report, path);
    return text_of_value(found.is_null() && *path_of_plain != 0 ? member(report, path_of_plain) : found);
  };
  return {name,
          value("/input"),
          value("/status"),
          value("/exit_status"),
          value("/message"),
          value("/triangles"),
          number_of_charts(report),
          value("/atlas/packing/covered_share"),
          value("/atlas/packing/texel_density"),
          value("/atlas/l2_stretch", "/l2_stretch"),
          value("/atlas/seams/relative_length", "/seams/length"),
          seconds_of(report),
          value("/peak_memory_mb")};
}

inline bool has_numbers(const Reports_summary::Row& row)
{
  for(std::size_t i = 0; i < row.size(); ++i) {
    if(summary_columns()[i].is_number && !row[i].empty() && !finite_number(row[i])) {
      return false;
    }
  }
  return true;
}

// Adds the charts of the last row.
inline void add_charts(const Json& report, Reports_summary& summary)
{
  std::vector<Summarized_chart>& worst = summary.worst;
  std::size_t number = 0;
  for(const Json& chart : member(report, "/atlas/charts")) {
    const auto value = [&chart](const char* path) {
      return finite_number(text_of_value(member(chart, path)));
    };
    worst.push_back({summary.rows.size() - 1, number++, value("/triangles"), value("/share_of_area"),
                     text_of_value(member(chart, "/method")),
                     value("/l2_stretch").value_or(std::numeric_limits<double>::infinity())});
  }
  std::stable_sort(worst.begin(), worst.end(), [](const Summarized_chart& a, const Summarized_chart& b) {
    return a.l2_stretch > b.l2_stretch;
  });
  worst.erase(worst.begin() +
                  static_cast<std::ptrdiff_t>((std::min)(worst.size(), Reports_summary::number_of_worst)),
              worst.end());
}

} // namespace internal

// Adds a file, as a report with a name or as one that is left out.
inline void add_report(const std::string& name, const std::string& file, Reports_summary& summary)
{
  const std::optional<Json> report = read_report(file);
  const Reports_summary::Row row = report ? internal::row_of_report(name, *report) : Reports_summary::Row();
  if(report && internal::has_numbers(row)) {
    summary.rows.push_back(row);
    internal::add_charts(*report, summary);
  } else {
    summary.left_out.push_back(file);
  }
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORTS_SUMMARY_H
