// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXTS_H
#define FLATTEN_MESH_TEXTS_H

#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare; // what makes surfaces of soups

struct Usage_error : public Input_error
{
  using Input_error::Input_error;
};

struct Output_error : public Input_error
{
  using Input_error::Input_error;
};

// Seams could not be computed. The program ends with status 1.
struct Seams_failed : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Rounding would make the result wrong. The program ends with status 1.
struct Precision_exceeded : public std::runtime_error
{
  using std::runtime_error::runtime_error;
};

const char* const memory_text =
    "not enough memory for this mesh; simplify it or use a machine with more memory";

// A number for people, as `printf` formats it.
inline std::string format_number(const char* format, const double number)
{
  char digits[64];
  std::snprintf(digits, sizeof(digits), format, number);
  return digits;
}

// A text in one line: characters that control terminals, as names may have, become escapes such as "\x0a".
inline std::string in_one_line(const std::string& text)
{
  std::string line;
  for(const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    char escape[8];
    std::snprintf(escape, sizeof(escape), "\\x%02x", static_cast<unsigned>(code));
    line += code < 0x20 || code == 0x7F ? std::string(escape) : std::string(1, c);
  }
  return line;
}

// Appends the shortest text that reads back as the same number, in any locale.
template <class Number>
void append_number(std::string& text, const Number number)
{
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof(digits), number).ptr);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TEXTS_H
