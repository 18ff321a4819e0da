// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_FILES_TEXT_NUMBERS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_FILES_TEXT_NUMBERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL::Texture_atlas::internal {

// Whether a word is a number, which may be none: "nan", "-nan(ind)", "inf", "1.#QNAN". Independent of the locale.
inline bool read_number(std::string_view word, double& number)
{
  if(word.size() > 1 && word[0] == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, number);
  if(result.ec == std::errc::result_out_of_range) { // infinite or nearly zero
    std::istringstream stream(std::string(word.data(), result.ptr));
    stream.imbue(std::locale::classic());
    if(!(stream >> number)) {
      number =
          word[0] == '-' ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
    }
  } else if(result.ec != std::errc()) {
    return false;
  }
  const std::string_view rest(result.ptr, static_cast<std::size_t>(end - result.ptr));
  if(rest.size() > 1 && rest[0] == '#' && *(result.ptr - 1) == '.') { // as Windows writes it
    number = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  return rest.empty();
}

inline bool read_finite_number(const std::string_view word, double& number)
{
  return read_number(word, number) && std::isfinite(number);
}

// Appends a number that reads back as the same bits, in as few digits as possible, or in the given number of digits.
inline void append_number(std::string& text, const double number, const int precision = 0)
{
  char digits[40];
  const std::to_chars_result result = precision == 0 ? std::to_chars(digits, digits + sizeof(digits), number)
                                                     : std::to_chars(digits, digits + sizeof(digits), number,
                                                                     std::chars_format::general, precision);
  text.append(digits, result.ptr);
}

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_FILES_TEXT_NUMBERS_H
