// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_TEXT_NUMBERS_H
#define FLATTEN_MESH_TEXT_NUMBERS_H

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace flatten_mesh {

// Whether a word is a number, which may be none: "nan", "-nan(ind)", "inf", "1.#QNAN". Independent of the locale.
inline bool read_number(std::string_view word, double& number)
{
  if(word.size() > 1 && word[0] == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, number);
  if(result.ec == std::errc::result_out_of_range) { // infinite or nearly zero
    number = std::strtod(std::string(word.data(), result.ptr).c_str(), nullptr);
  } else if(result.ec != std::errc()) {
    return false;
  }
  const std::string_view rest(result.ptr, static_cast<std::size_t>(end - result.ptr));
  if(rest.size() > 1 && rest[0] == '#' && (rest[1] < '0' || rest[1] > '9')) { // as Windows writes it
    number = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  return rest.empty();
}

inline bool read_finite_number(const std::string_view word, double& number)
{
  return read_number(word, number) && std::isfinite(number);
}

// Whether a word is a count, or the number of an element from 0.
inline bool read_count(const std::string_view word, std::size_t& count)
{
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, count);
  return result.ec == std::errc() && result.ptr == end;
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
