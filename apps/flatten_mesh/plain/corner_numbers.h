// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CORNER_NUMBERS_H
#define FLATTEN_MESH_CORNER_NUMBERS_H

#include <boost/algorithm/string.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The whole word as a number; nothing if it is something else
template <class Number>
std::optional<Number> number_of(const std::string& word)
{
  Number number;
  const char* const end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, number);
  return result.ec == std::errc() && result.ptr == end ? std::optional<Number>(number) : std::nullopt;
}

inline std::vector<std::string> words_of(const std::string& text, const char* separators)
{
  std::vector<std::string> words;
  const std::string trimmed = boost::algorithm::trim_copy(text);
  if(!trimmed.empty()) {
    boost::algorithm::split(words, trimmed, boost::algorithm::is_any_of(separators),
                            boost::algorithm::token_compress_on);
  }
  return words;
}

} // namespace internal

// The four numbers in "1,20,300,4000"; nothing if the text is something else
inline std::optional<std::array<std::size_t, 4>> corner_numbers(const std::string& text)
{
  const std::vector<std::string> words = internal::words_of(text, ",");
  std::array<std::size_t, 4> numbers;
  if(words.size() != numbers.size()) {
    return std::nullopt;
  }
  for(std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = internal::number_of<std::size_t>(words[i]);
    if(!number || std::find(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(i), *number) !=
                      numbers.begin() + static_cast<std::ptrdiff_t>(i)) {
      return std::nullopt;
    }
    numbers[i] = *number;
  }
  return numbers;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CORNER_NUMBERS_H
