// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CORNER_NUMBERS_H
#define FLATTEN_MESH_CORNER_NUMBERS_H

#include "flatten_mesh/model/text_numbers.h"

#include <boost/algorithm/string.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace flatten_mesh {

// The four different numbers in "1,20,300,4000"; nothing if the text is something else
inline std::optional<std::array<std::size_t, 4>> corner_numbers(const std::string& text)
{
  std::vector<std::string> words;
  boost::algorithm::split(words, boost::algorithm::trim_copy(text), boost::algorithm::is_any_of(","),
                          boost::algorithm::token_compress_on);
  std::array<std::size_t, 4> numbers;
  bool is_right = words.size() == numbers.size();
  for(std::size_t i = 0; is_right && i < numbers.size(); ++i) {
    is_right = read_count(words[i], numbers[i]);
  }
  is_right = is_right && std::set<std::size_t>(numbers.begin(), numbers.end()).size() == numbers.size();
  return is_right ? std::optional(numbers) : std::nullopt;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CORNER_NUMBERS_H
