// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_TABLES_H
#define HIERARCHICAL_TABLES_H

#include "Measurement.h"

#include "../common/format.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace hierarchical {

using namespace benchmarks;

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

// Ratios and rises of what was not measured are NaN, and become dashes.
inline double rise(const Measurement& from, const Measurement& to, const char* name)
{
  return to[name] - from[name];
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

// The table of what was to be reached and what was. A number that was not measured misses its target.
class Targets
{
public:
  void at_most(const std::string& what, const char* format, const double number, const double limit)
  {
    add(what, std::string("at most ") + format_number(format, limit), format, number, number <= limit);
  }

  void at_least(const std::string& what, const char* format, const double number, const double limit)
  {
    add(what, std::string("at least ") + format_number(format, limit), format, number, number >= limit);
  }

  std::string text() const { return "\n" + m_table.text(); }

private:
  void add(const std::string& what, const std::string& limit, const char* format, const double number,
           const bool met)
  {
    m_table.add({what, limit, cell(format, number),
                 std::isnan(number) ? "not measured"
                 : met              ? "yes"
                                    : "NO"});
  }

  Table m_table{{"target", "limit", "measured", "met"}, 1};
};

} // namespace hierarchical

#endif // HIERARCHICAL_TABLES_H
