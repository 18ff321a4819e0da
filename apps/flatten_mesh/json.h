// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_JSON_H
#define FLATTEN_MESH_JSON_H

#include "flatten_mesh/texts.h"

#include <boost/locale/utf.hpp>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// A byte that is no part of UTF-8, as in names of files, becomes the replacement character U+FFFD.
inline std::string json_text(const std::string& value)
{
  namespace utf = boost::locale::utf;
  std::string text = "\"";
  for(auto begin = value.begin(); begin != value.end();) {
    auto end = begin;
    const utf::code_point code = utf::utf_traits<char>::decode(end, value.end());
    if(code == utf::illegal || code == utf::incomplete) {
      text += "\\ufffd";
      end = begin + 1;
    } else if(code < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned>(code));
      text += escape;
    } else {
      text += code == '"' || code == '\\' ? "\\" : "";
      text.append(begin, end);
    }
    begin = end;
  }
  return text + '"';
}

// JSON has finite numbers only.
template <class Number>
std::string json_number(const Number number)
{
  std::string text;
  if(!std::isfinite(static_cast<double>(number))) {
    return "null";
  }
  append_number(text, number);
  return text;
}

inline std::string json_bool(const bool value)
{
  return value ? "true" : "false";
}

// `text_of(i)` is the JSON of the value number i.
template <class Values, class Text>
std::string json_array(const Values& values, const Text& text_of)
{
  std::string text;
  for(std::size_t i = 0; i < values.size(); ++i) {
    text += (text.empty() ? "" : ", ") + text_of(i);
  }
  return "[" + text + "]";
}

inline std::string json_texts(const std::vector<std::string>& values)
{
  std::string text;
  for(const std::string& value : values) {
    text += (text.empty() ? "" : ", ") + json_text(value);
  }
  return "[" + text + "]";
}

// Builds an object from members whose values are JSON.
class Json_object
{
public:
  void add(const std::string& key, const std::string& value)
  {
    m_members += (m_members.empty() ? "" : ", ") + json_text(key) + ": " + value;
  }

  std::string text() const { return "{" + m_members + "}"; }

private:
  std::string m_members;
};

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_JSON_H
