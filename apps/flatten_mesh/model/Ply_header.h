// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PLY_HEADER_H
#define FLATTEN_MESH_PLY_HEADER_H

#include "flatten_mesh/model/Text_reader.h"
#include "flatten_mesh/model/own_marks.h"
#include "flatten_mesh/model/text_numbers.h"

#include <boost/algorithm/string/predicate.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flatten_mesh {

enum class Ply_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  INT64,
  UINT64,
  FLOAT32,
  FLOAT64
};

struct Ply_property
{
  std::string name;
  Ply_type type = Ply_type::FLOAT32;
  bool is_list = false;
  Ply_type count_type = Ply_type::UINT8; // of a list
};

struct Ply_element
{
  std::string name;
  std::size_t count = 0; // as the header says
  std::vector<Ply_property> properties;

  bool is_named(const char* singular, const char* plural) const { return name == singular || name == plural; }

  // The number of a property, or the number of properties if it does not exist
  std::size_t find(const std::string& property) const
  {
    std::size_t k = 0;
    while(k < properties.size() && properties[k].name != property) {
      ++k;
    }
    return k;
  }
};

// The header of a PLY file
struct Ply_header
{
  bool is_text = false, is_big_endian = false;
  bool names_textures = false; // in comments
  bool is_own = false;         // written by this program
  std::vector<Ply_element> elements;
};

namespace internal {

class Ply_header_reader
{
public:
  explicit Ply_header_reader(Text_reader& text) : m_text(text) {}

  // Leaves the text at the last line of the header.
  Ply_header read()
  {
    m_text.lines.next();
    if(m_text.lines.word() != "ply") {
      m_text.refuse("a PLY file begins with 'ply'; export the mesh again");
    }
    bool has_format = false;
    std::string keyword;
    while(keyword != "end_header") {
      if(!m_text.lines.next()) {
        m_text.refuse("the header of the file has no end, so it was cut short; export the mesh again");
      }
      keyword = m_text.lines.word();
      has_format = has_format || keyword == "format";
      read_line(keyword);
    }
    if(!has_format) {
      m_text.refuse("the header has no line 'format'; export the mesh again");
    }
    return std::move(m_header);
  }

private:
  void read_line(const std::string& keyword)
  {
    if(keyword == "format") {
      read_format(m_text.lines.word());
    } else if(keyword == "element") {
      read_element();
    } else if(keyword == "property") {
      read_property();
    } else if(keyword == "comment") {
      m_header.names_textures = m_header.names_textures || m_text.lines.word() == "TextureFile";
      m_header.is_own =
          m_header.is_own || boost::algorithm::ends_with(m_text.lines.rest(), end_of_ply_comment);
    } else if(!keyword.empty() && keyword != "obj_info" && keyword != "end_header") {
      m_text.refuse(quoted_word(keyword) + " is not a keyword of PLY headers; export the mesh again");
    }
  }

  void read_format(const std::string_view name)
  {
    m_header.is_text = name == "ascii";
    m_header.is_big_endian = name == "binary_big_endian";
    if(!m_header.is_text && !m_header.is_big_endian && name != "binary_little_endian") {
      m_text.refuse("the format " + quoted_word(name) + " is unknown; export the mesh again");
    }
  }

  void read_element()
  {
    Ply_element element;
    element.name = m_text.lines.word();
    const std::string_view count = m_text.lines.word();
    if(!read_count(count, element.count)) {
      m_text.refuse(quoted_word(count) + " is not a number of elements; export the mesh again");
    }
    m_header.elements.push_back(std::move(element));
  }

  void read_property()
  {
    Ply_property property;
    std::string_view type = m_text.lines.word();
    property.is_list = type == "list";
    if(property.is_list) {
      property.count_type = type_named(m_text.lines.word());
      type = m_text.lines.word();
    }
    property.type = type_named(type);
    property.name = m_text.lines.word();
    if(m_header.elements.empty()) {
      m_text.refuse("a property stands before the first element; export the mesh again");
    }
    m_header.elements.back().properties.push_back(std::move(property));
  }

  Ply_type type_named(const std::string_view name) const
  {
    static const std::array<std::array<const char*, 2>, 10> names = {{{"char", "int8"},
                                                                      {"uchar", "uint8"},
                                                                      {"short", "int16"},
                                                                      {"ushort", "uint16"},
                                                                      {"int", "int32"},
                                                                      {"uint", "uint32"},
                                                                      {"long", "int64"},
                                                                      {"ulong", "uint64"},
                                                                      {"float", "float32"},
                                                                      {"double", "float64"}}};
    for(std::size_t i = 0; i < names.size(); ++i) {
      if(name == names[i][0] || name == names[i][1]) {
        return static_cast<Ply_type>(i);
      }
    }
    m_text.refuse("the type " + quoted_word(name) + " is unknown; export the mesh again");
  }

  Text_reader& m_text;
  Ply_header m_header;
};

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PLY_HEADER_H
