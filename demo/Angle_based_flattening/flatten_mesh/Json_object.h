// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_JSON_OBJECT_H
#define FLATTEN_MESH_JSON_OBJECT_H

#include "number_text.h"

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace flatten_mesh {

// The text of a JSON object, member by member. Numbers that JSON does not know become `null`.
class Json_object
{
public:
  void add(const std::string& key, const std::string& value)
  {
    begin_member(key);
    append_string(value);
  }

  void add(const std::string& key, const double value)
  {
    begin_member(key);
    if(std::isfinite(value)) {
      append_number(m_members, value);
    } else {
      m_members += "null";
    }
  }

  void add(const std::string& key, const std::size_t value)
  {
    begin_member(key);
    append_number(m_members, value);
  }

  void add(const std::string& key, const Json_object& value)
  {
    begin_member(key);
    m_members += value.text();
  }

  void add_null(const std::string& key)
  {
    begin_member(key);
    m_members += "null";
  }

  std::string text() const { return "{" + m_members + "}"; }

private:
  void begin_member(const std::string& key)
  {
    m_members += m_members.empty() ? "" : ", ";
    append_string(key);
    m_members += ": ";
  }

  void append_string(const std::string& value)
  {
    m_members += '"';
    for(const char c : value) {
      if(c == '"' || c == '\\') {
        m_members += '\\';
        m_members += c;
      } else if(static_cast<unsigned char>(c) < 0x20) {
        char escape[8];
        std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned>(c));
        m_members += escape;
      } else {
        m_members += c;
      }
    }
    m_members += '"';
  }

  std::string m_members;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_JSON_OBJECT_H
