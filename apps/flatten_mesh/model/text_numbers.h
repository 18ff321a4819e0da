// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXT_NUMBERS_H
#define FLATTEN_MESH_TEXT_NUMBERS_H

#include <CGAL/Texture_atlas/internal/files/text_lines.h>

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

namespace flatten_mesh {

using CGAL::Texture_atlas::internal::read_finite_number;
using CGAL::Texture_atlas::internal::read_number;

// Whether a word is a count, or the number of an element from 0.
inline bool read_count(const std::string_view word, std::size_t& count)
{
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, count);
  return result.ec == std::errc() && result.ptr == end;
}

// The whole text as a number; nothing if it is something else
inline std::optional<double> finite_number(const std::string_view text)
{
  double number;
  return read_finite_number(text, number) ? std::optional(number) : std::nullopt;
}

// The number of an element, counted from 1, or backwards from the last of `before`, as the number from 0. Negative if
// there is no such element before. False if the word is no number, or zero.
inline bool read_obj_index(const std::string_view word, const std::size_t before, long long& index)
{
  long long number = 0;
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, number);
  index = number < 0 ? static_cast<long long>(before) + number : number - 1;
  return result.ec == std::errc() && result.ptr == end && number != 0;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_TEXT_NUMBERS_H
