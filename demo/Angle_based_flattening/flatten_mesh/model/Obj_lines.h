// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OBJ_LINES_H
#define FLATTEN_MESH_OBJ_LINES_H

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>

namespace flatten_mesh {

// The lines of an OBJ or MTL file, word by word.
class Obj_lines
{
public:
  explicit Obj_lines(std::istream& file) : m_file(file) {}

  // Goes to the next line, which has its continuation lines in it. False at the end of the file.
  bool next()
  {
    m_line.clear();
    m_position = 0;
    m_number += m_lines_taken;
    m_lines_taken = 0;
    bool continues = true;
    while(continues && std::getline(m_file, m_part)) {
      ++m_lines_taken;
      if(!m_part.empty() && m_part.back() == '\r') {
        m_part.pop_back();
      }
      continues = !m_part.empty() && m_part.back() == '\\';
      if(continues) {
        m_part.back() = ' ';
      }
      m_line += m_part;
    }
    return m_lines_taken > 0;
  }

  // From 1; of several lines that belong together, that of the first
  std::size_t number() const { return m_number; }

  // Empty at the end of the line, or where a comment begins
  std::string_view word()
  {
    const auto begin = std::find_if_not(m_line.begin() + m_position, m_line.end(), is_blank);
    const auto end = std::find_if(begin, m_line.end(), is_blank);
    m_position = end - m_line.begin();
    if(begin == end || *begin == '#') {
      return {};
    }
    return {&*begin, static_cast<std::size_t>(end - begin)};
  }

  // What follows, without blanks around it: names have blanks inside.
  std::string rest()
  {
    const auto begin = std::find_if_not(m_line.begin() + m_position, m_line.end(), is_blank);
    auto end = begin;
    for(auto c = begin; c != m_line.end() && (*c != '#' || (c != begin && !is_blank(*(c - 1)))); ++c) {
      end = is_blank(*c) ? end : c + 1;
    }
    m_position = m_line.end() - m_line.begin();
    return std::string(begin, end);
  }

private:
  static bool is_blank(const char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

  std::istream& m_file;
  std::string m_line, m_part;
  std::ptrdiff_t m_position = 0;
  std::size_t m_number = 1;
  std::size_t m_lines_taken = 0;
};

// Whether a word is a finite number. Independent of the locale.
inline bool read_finite_number(std::string_view word, double& number)
{
  if(word.size() > 1 && word[0] == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, number);
  return result.ec == std::errc() && result.ptr == end && std::isfinite(number);
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

#endif // FLATTEN_MESH_OBJ_LINES_H
