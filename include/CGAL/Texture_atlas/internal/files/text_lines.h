// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_FILES_TEXT_LINES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_FILES_TEXT_LINES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <algorithm>
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

// The lines of a text, word by word. They end as on any system: "\n", "\r\n" or "\r", also mixed. The text has to
// stay where it is; words too, as long as no lines are joined.
class Text_lines
{
public:
  enum Joining
  {
    NOTHING,
    BACKSLASHES // a line that ends with one goes on in the next
  };

  explicit Text_lines(const std::string_view text, const Joining joining = NOTHING)
      : m_text(text), m_joins(joining == BACKSLASHES)
  {}

  // Goes to the next line, which has its continuation lines in it. False at the end of the text.
  bool next()
  {
    m_number += m_lines_taken;
    m_lines_taken = 0;
    m_position = 0;
    m_line = {};
    if(m_next == m_text.size()) {
      return false;
    }
    m_line = take_line();
    if(m_joins && !m_line.empty() && m_line.back() == '\\') {
      join_lines();
    }
    return true;
  }

  // From 1; of several lines that belong together, that of the first. At the end of the text, that after the last.
  std::size_t number() const { return m_number; }

  // Where the line ends in the text, and where the next begins
  std::size_t end_of_line() const { return m_end; }
  std::size_t next_line() const { return m_next; }

  void skip_rest() { m_position = static_cast<std::ptrdiff_t>(m_line.size()); }

  // Empty at the end of the line, or where a comment begins. A comment may follow a word without a blank.
  std::string_view word()
  {
    const auto begin = std::find_if_not(m_line.begin() + m_position, m_line.end(), is_blank);
    auto end = std::find_if(begin, m_line.end(), is_blank);
    m_position = end - m_line.begin();
    const auto comment = std::find(begin, end, '#');
    if(comment != end && (comment == begin || *(comment - 1) != '.')) { // "1.#QNAN" is no comment
      end = comment;
      skip_rest();
    }
    return begin == end ? std::string_view()
                        : std::string_view(&*begin, static_cast<std::size_t>(end - begin));
  }

  // The next word, in whatever line. Empty at the end of the text
  std::string_view word_in_any_line()
  {
    std::string_view found = word();
    while(found.empty() && next()) {
      found = word();
    }
    return found;
  }

  // What follows, without blanks around it: names have blanks inside.
  std::string rest()
  {
    const auto begin = std::find_if_not(m_line.begin() + m_position, m_line.end(), is_blank);
    auto end = begin;
    for(auto c = begin; c != m_line.end() && (*c != '#' || (c != begin && !is_blank(*(c - 1)))); ++c) {
      end = is_blank(*c) ? end : c + 1;
    }
    skip_rest();
    return std::string(begin, end);
  }

private:
  static bool is_blank(const char c) { return c == ' ' || c == '\t' || c == '\f' || c == '\v'; }
  static bool ends_line(const char c) { return c == '\n' || c == '\r'; }

  // Without its end
  std::string_view take_line()
  {
    const auto begin = m_text.begin() + static_cast<std::ptrdiff_t>(m_next);
    const auto end = std::find_if(begin, m_text.end(), ends_line);
    const std::string_view line = m_text.substr(m_next, static_cast<std::size_t>(end - begin));
    m_end = m_next + line.size();
    m_next = (std::min)(m_end + 1, m_text.size());
    if(m_next < m_text.size() && m_text[m_end] == '\r' && m_text[m_next] == '\n') {
      ++m_next;
    }
    ++m_lines_taken;
    return line;
  }

  void join_lines()
  {
    m_joined.clear();
    std::string_view part = m_line;
    while(!part.empty() && part.back() == '\\') {
      part.remove_suffix(1);
      m_joined.append(part) += ' ';
      part = m_next < m_text.size() ? take_line() : std::string_view();
    }
    m_joined.append(part);
    m_line = m_joined;
  }

  std::string_view m_text, m_line;
  std::string m_joined;
  bool m_joins;
  std::size_t m_end = 0, m_next = 0; // in the text
  std::ptrdiff_t m_position = 0;     // in the line
  std::size_t m_number = 1;
  std::size_t m_lines_taken = 0;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_FILES_TEXT_LINES_H
