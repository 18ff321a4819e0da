// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PLY_ITEMS_H
#define FLATTEN_MESH_PLY_ITEMS_H

#include "flatten_mesh/model/Binary_data.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Ply_header.h"
#include "flatten_mesh/model/Text_reader.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Reads the items of the elements of a PLY file, such as vertices, one by one: the numbers of each property.
class Ply_items
{
public:
  // The text has to be at the end of the header.
  Ply_items(const std::string_view content, Text_reader& text, const Ply_header& header, const Model& model)
      : m_text(text), m_header(header), m_model(model),
        m_bytes(content.substr(first_byte(content, text.lines)),
                header.is_big_endian ? boost::endian::order::big : boost::endian::order::little)
  {}

  // Throws an `Input_error` at the end of the file. Counts are not believed before there are so many.
  void read(const Ply_element& element, const std::size_t item)
  {
    m_element = &element;
    m_item = item;
    m_line = 0;
    numbers.resize(element.properties.size());
    for(std::size_t k = 0; k < element.properties.size(); ++k) {
      const Ply_property& property = element.properties[k];
      std::vector<double>& values = numbers[k];
      values.clear();
      if(property.is_list) {
        read_list(property, values);
      } else {
        values.push_back(number(property, property.type));
      }
    }
    if(m_header.is_text) {
      end_text_item();
    }
  }

  [[noreturn]] void refuse(const std::string& what) const
  {
    if(m_header.is_text) {
      m_text.refuse_at(m_line, name() + what);
    }
    throw Input_error("'" + m_model.name + "': " + name() + what);
  }

  std::vector<std::vector<double>> numbers; // of each property of the item that was read last

private:
  // Of binary data. Where lines end with "\r", what follows is data also if it looks like "\n".
  static std::size_t first_byte(const std::string_view content, const Text_lines& lines)
  {
    const std::size_t end = content.find_first_of("\r\n"), next = end + 1;
    const bool is_mac = content[end] == '\r' && next < content.size() && content[next] != '\n';
    return is_mac ? (std::min)(lines.end_of_line() + 1, content.size()) : lines.next_line();
  }

  std::string name() const
  {
    const std::string singular = m_element->is_named("vertex", "vertices") ? "vertex"
                                 : m_element->is_named("face", "faces")    ? "face"
                                                                           : "item";
    return singular + " " + std::to_string(m_item + 1) +
           (singular == "item" ? " of '" + m_element->name + "'" : "");
  }

  // An item that goes over several lines ends with its last: otherwise some of its numbers are missing.
  void end_text_item()
  {
    if(m_line != m_text.lines.number() && !m_text.lines.word().empty()) {
      m_text.refuse_at(m_line, name() + " has fewer numbers than it has to have; export the mesh again");
    }
    m_text.lines.skip_rest();
  }

  void read_list(const Ply_property& property, std::vector<double>& values)
  {
    const double count = number(property, property.count_type);
    if(count < 0 || count != std::floor(count)) {
      refuse(" has a list of " + format_number("%g", count) + " numbers; export the mesh again");
    }
    for(double i = 0; i < count; ++i) {
      values.push_back(number(property, property.type));
    }
  }

  double number(const Ply_property& property, const Ply_type type)
  {
    return m_header.is_text ? text_number(property) : binary_number(type);
  }

  double text_number(const Ply_property& property)
  {
    const std::string_view word = m_text.lines.word_in_any_line();
    if(word.empty()) {
      refuse_end();
    }
    m_line = m_line == 0 ? m_text.lines.number() : m_line;
    double result = 0;
    if(!read_number(word, result)) {
      m_text.refuse("the value " + quoted_word(word) + " of " + name() + ", property '" + property.name +
                    "', is not a number; export the mesh again");
    }
    return result;
  }

  double binary_number(const Ply_type type)
  {
    switch(type) {
    case Ply_type::INT8:
      return binary_number_of<std::int8_t>();
    case Ply_type::UINT8:
      return binary_number_of<std::uint8_t>();
    case Ply_type::INT16:
      return binary_number_of<std::int16_t>();
    case Ply_type::UINT16:
      return binary_number_of<std::uint16_t>();
    case Ply_type::INT32:
      return binary_number_of<std::int32_t>();
    case Ply_type::UINT32:
      return binary_number_of<std::uint32_t>();
    case Ply_type::INT64:
      return binary_number_of<std::int64_t>();
    case Ply_type::UINT64:
      return binary_number_of<std::uint64_t>();
    case Ply_type::FLOAT32:
      return binary_number_of<float>();
    default:
      return binary_number_of<double>();
    }
  }

  template <class Number>
  double binary_number_of()
  {
    Number result = 0;
    if(!m_bytes.read(result)) {
      refuse_end();
    }
    return static_cast<double>(result);
  }

  [[noreturn]] void refuse_end() const
  {
    throw Input_error(
        "'" + m_model.name + "': the header promises " + std::to_string(m_element->count) + " of '" +
        m_element->name + "', but the file ends " +
        (m_header.is_text ? "after line " + std::to_string(m_text.lines.number() - 1) + " " : "") + "in " +
        name() + ": it was cut short, or a count is wrong; export the mesh again");
  }

  Text_reader& m_text;
  const Ply_header& m_header;
  const Model& m_model;
  Binary_data m_bytes;
  const Ply_element* m_element = nullptr;
  std::size_t m_item = 0;
  std::size_t m_line = 0; // where the item begins
};

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PLY_ITEMS_H
