// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_NUMBER_TEXT_H
#define FLATTEN_MESH_NUMBER_TEXT_H

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <string>

namespace flatten_mesh {

// Appends the shortest text that reads back as the very same number, whatever the locale.
template <class Number>
void append_number(std::string& text, const Number number)
{
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), number).ptr);
}

// A number for people, as `printf` formats it.
inline std::string format_number(const char* format, const double number)
{
  char digits[64];
  std::snprintf(digits, sizeof(digits), format, number);
  return digits;
}

// A count with its noun: "1 border", "3 borders".
inline std::string count_text(const std::size_t count, const std::string& noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_NUMBER_TEXT_H
