// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_TABLE_H
#define BENCHMARKS_COMMON_TABLE_H

#include "Measurement.h"
#include "format.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace benchmarks {

// A dash for what was not measured
inline std::string cell(const char* format, const double number)
{
  return std::isnan(number) ? "–" : format_number(format, number);
}

inline std::string seconds_cell(const double seconds)
{
  return std::isnan(seconds) ? "–" : format_seconds(seconds);
}

inline std::string count_cell(const double number)
{
  return cell("%.0f", number);
}

// A Markdown table
class Table
{
public:
  Table(const std::vector<std::string>& titles, const std::size_t text_columns)
      : m_columns(titles.size()), m_text(markdown_head(titles, text_columns))
  {}

  void add(std::vector<std::string> cells)
  {
    cells.resize(m_columns);
    m_text += markdown_row(cells);
  }

  // The first cells, and then the reason why there are no others
  void add_failure(std::vector<std::string> cells, const Measurement& measurement)
  {
    cells.resize(m_columns - 1, "–");
    cells.push_back("FAILED: " + measurement.failure);
    add(cells);
  }

  const std::string& text() const { return m_text; }

private:
  std::size_t m_columns;
  std::string m_text;
};

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_TABLE_H
