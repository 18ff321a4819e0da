// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SUMMARY_PAGE_H
#define FLATTEN_MESH_SUMMARY_PAGE_H

#include "flatten_mesh/batch/Reports_summary.h"
#include "flatten_mesh/json.h"
#include "flatten_mesh/report/page_text.h"

#include <boost/algorithm/string/replace.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace flatten_mesh {

namespace internal {

inline std::string json_optional(const std::optional<double>& number)
{
  return number ? json_number(*number) : "null";
}

inline std::string summary_row_json(const Reports_summary::Row& row)
{
  return json_array(row, [&row](const std::size_t i) {
    return summary_columns()[i].is_number ? json_optional(finite_number(row[i])) : json_text(row[i]);
  });
}

inline std::string worst_chart_json(const Summarized_chart& chart)
{
  Json_object json;
  json.add("row", json_number(chart.row));
  json.add("number", json_number(chart.number));
  json.add("triangles", json_optional(chart.triangles));
  json.add("share_of_area", json_optional(chart.share_of_area));
  json.add("method", json_text(chart.method));
  json.add("l2_stretch", json_number(chart.l2_stretch));
  return json.text();
}

} // namespace internal

// The summary of the reports in a folder as a page for browsers that refers to nothing outside of it
inline std::string summary_page(const std::string& folder, const Reports_summary& summary)
{
  using internal::json_array;
  using internal::json_text;
  internal::Json_object json;
  json.add("folder", json_text(folder));
  json.add("version", json_text(ABF_VERSION));
  json.add("columns", json_array(summary_columns(),
                                 [](const std::size_t i) { return json_text(summary_columns()[i].name); }));
  json.add("rows", json_array(summary.rows, [&summary](const std::size_t i) {
             return internal::summary_row_json(summary.rows[i]);
           }));
  json.add("worst", json_array(summary.worst, [&summary](const std::size_t i) {
             return internal::worst_chart_json(summary.worst[i]);
           }));
  json.add("left_out", internal::json_texts(summary.left_out));
  return page_text(summary_page_parts, "Reports in " + folder,
                   "<script type=\"application/json\" id=\"summary\">" +
                       boost::replace_all_copy(json.text(), "<", "\\u003c") + "</script>\n");
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SUMMARY_PAGE_H
