// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_NUMBER_LIST_H
#define BENCHMARKS_COMMON_NUMBER_LIST_H

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace benchmarks {

// What stands between the commas
inline std::vector<std::string> words_of_list(const std::string& list)
{
  std::vector<std::string> words;
  std::istringstream stream(list);
  for(std::string word; std::getline(stream, word, ',');) {
    words.push_back(word);
  }
  return words;
}

// The numbers between the commas. `option` is named if one of them is not between `least` and `most`.
template <class Number>
std::vector<Number> numbers_of_list(const std::string& list, const std::string& option, const Number least,
                                    const Number most)
{
  std::vector<Number> numbers;
  for(const std::string& word : words_of_list(list)) {
    std::istringstream digits(word);
    Number number = 0;
    if(!(digits >> number) || !digits.eof() || number < least || number > most) {
      std::ostringstream message;
      message << option << " takes numbers from " << least << " to " << most << ", with commas between them";
      throw std::runtime_error(message.str());
    }
    numbers.push_back(number);
  }
  return numbers;
}

// Numbers of triangles
inline std::vector<std::size_t> triangles_of_list(const std::string& list, const std::string& option)
{
  const std::vector<long> numbers = numbers_of_list<long>(list, option, 100, 1000000000);
  return {numbers.begin(), numbers.end()};
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_NUMBER_LIST_H
