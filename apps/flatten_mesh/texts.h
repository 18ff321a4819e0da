// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXTS_H
#define FLATTEN_MESH_TEXTS_H

#include <charconv>
#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

// An error that the user has to correct, in the command line or in a file. The text is one line that names the error
// and the remedy. The program ends with status 2.
struct Input_error : public std::runtime_error
{
  std::vector<std::size_t> faces, vertices; // of the file, from 0, that the text names

  Input_error(const std::string& text, std::vector<std::size_t> faces = {},
              std::vector<std::size_t> vertices = {})
      : std::runtime_error(text), faces(std::move(faces)), vertices(std::move(vertices))
  {}
};

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

// Vertices and faces counted from 1, as in OBJ files.
inline std::string vertex_name(const std::size_t index)
{
  return "vertex " + std::to_string(index + 1);
}

inline std::string face_name(const std::size_t index)
{
  return "face " + std::to_string(index + 1);
}

// A count with its noun: "1 border", "3 borders".
inline std::string count_text(const std::size_t count, const std::string& noun,
                              const std::string& plural = "")
{
  return std::to_string(count) + " " + (count == 1 ? noun : plural.empty() ? noun + "s" : plural);
}

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
