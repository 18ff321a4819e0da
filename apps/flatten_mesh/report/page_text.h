// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PAGE_TEXT_H
#define FLATTEN_MESH_PAGE_TEXT_H

#include "flatten_mesh/report/page_parts.h"

#include <boost/locale/encoding_utf.hpp>

#include <string>

namespace flatten_mesh {

namespace internal {

inline void append_parts(std::string& text, const char* const* parts)
{
  for(; *parts != nullptr; ++parts) {
    text += *parts;
  }
}

inline std::string escaped_html(const std::string& title)
{
  std::string text;
  for(const char c : boost::locale::conv::utf_to_utf<char>(title)) {
    if(c == '&' || c == '<' || c == '>' || c == '"' || c == '\'') {
      text += "&#" + std::to_string(static_cast<int>(c)) + ";";
    } else {
      text += c;
    }
  }
  return text;
}

} // namespace internal

// A page with elements for its scripts, which are HTML
inline std::string page_text(const Page_parts& parts, const std::string& title, const std::string& elements)
{
  std::string page;
  internal::append_parts(page, parts.before_title);
  page += internal::escaped_html(title);
  internal::append_parts(page, parts.before_data);
  page += elements;
  internal::append_parts(page, parts.after_data);
  return page;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PAGE_TEXT_H
