// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_FORMAT_H
#define BENCHMARKS_COMMON_FORMAT_H

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace benchmarks {

// A number as `printf` formats it.
inline std::string format_number(const char* format, const double number)
{
  char digits[64];
  std::snprintf(digits, sizeof(digits), format, number);
  return digits;
}

// Enough digits to compare times by
inline std::string format_seconds(const double seconds)
{
  return format_number(seconds < 1 ? "%.3f" : seconds < 100 ? "%.2f" : "%.0f", seconds);
}

inline std::string markdown_row(const std::vector<std::string>& cells)
{
  std::string row = "|";
  for(const std::string& cell : cells) {
    row += " " + cell + " |";
  }
  return row + "\n";
}

// The first columns are text, the others are numbers.
inline std::string markdown_head(const std::vector<std::string>& titles, const std::size_t text_columns)
{
  std::vector<std::string> rule(titles.size(), "---:");
  for(std::size_t i = 0; i < text_columns; ++i) {
    rule[i] = "---";
  }
  return markdown_row(titles) + markdown_row(rule);
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_FORMAT_H
