// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SUMMARY_PAGE_H
#define FLATTEN_MESH_SUMMARY_PAGE_H

#include "flatten_mesh/Json.h"
#include "flatten_mesh/batch/Reports_summary.h"
#include "flatten_mesh/report/page_text.h"

#include <cstddef>
#include <string>

namespace flatten_mesh {

namespace internal {

inline Json summary_row_json(const Reports_summary::Row& row)
{
  Json json = Json::array();
  for(std::size_t i = 0; i < row.size(); ++i) {
    json.push_back(summary_columns()[i].is_number ? json_optional(finite_number(row[i])) : Json(row[i]));
  }
  return json;
}

inline Json worst_chart_json(const Summarized_chart& chart)
{
  return {{"row", chart.row},
          {"number", chart.number},
          {"triangles", json_optional(chart.triangles)},
          {"share_of_area", json_optional(chart.share_of_area)},
          {"method", chart.method},
          {"l2_stretch", chart.l2_stretch}};
}

} // namespace internal

// The summary of the reports in a folder as a page for browsers that refers to nothing outside of it
inline std::string summary_page(const std::string& folder, const Reports_summary& summary)
{
  using internal::json_array;
  const auto name = [](const Summary_column& column) { return column.name; };
  const Json json = {{"folder", folder},
                     {"version", ABF_VERSION},
                     {"columns", json_array(summary_columns(), name)},
                     {"rows", json_array(summary.rows, internal::summary_row_json)},
                     {"worst", json_array(summary.worst, internal::worst_chart_json)},
                     {"left_out", summary.left_out}};
  return page_text(summary_page_parts, "Reports in " + folder,
                   "<script type=\"application/json\" id=\"summary\">" + internal::json_for_html(json) +
                       "</script>\n");
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SUMMARY_PAGE_H
