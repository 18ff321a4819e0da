// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_REPORT_ROWS_H
#define FLATTEN_MESH_REPORT_ROWS_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

// A line of the report for people. Without value, it is the heading of the lines below.
struct Report_row
{
  std::string label;
  std::string value = {};
  std::string remark = {};
};

using Report_rows = std::vector<Report_row>;

inline void append(Report_rows& rows, const Report_rows& others)
{
  rows.insert(rows.end(), others.begin(), others.end());
}

inline std::string report_line(const Report_row& row)
{
  std::string line = row.label;
  if(!row.value.empty()) {
    line.resize((std::max)(line.size(), std::size_t(22)), ' ');
    line += row.value;
  }
  if(!row.remark.empty()) {
    line.resize((std::max)(line.size() + 2, std::size_t(36)), ' ');
    line += "(" + row.remark + ")";
  }
  return line + "\n";
}

inline std::string rows_text(const Report_rows& rows)
{
  std::string text;
  for(const Report_row& row : rows) {
    text += report_line(row);
  }
  return text;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_REPORT_ROWS_H
