// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_STL_H
#define FLATTEN_MESH_READ_STL_H

#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Binary_data.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Text_reader.h"
#include "flatten_mesh/texts.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <boost/container_hash/hash.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>

namespace flatten_mesh {

namespace internal {

// Reads an STL file, and merges equal points. CGAL's reader puts NaN into a sorted set, believes all counts, and does
// not report the line that it does not understand.
class Stl_reader
{
public:
  Stl_reader(const std::string_view content, Model& model, const Degenerate_faces degenerate)
      : m_content(content), m_text(content, model, degenerate), m_model(model)
  {}

  // Binary files may begin with the word for text, and a count that fits tells.
  void read(Notes& notes)
  {
    std::uint32_t count = 0;
    Binary_data bytes(m_content, boost::endian::order::little);
    bytes.skip(header_size);
    const bool has_count = bytes.read(count), fits = has_count && bytes.size() == triangle_size * count;
    const std::string begin(boost::algorithm::trim_left_copy(std::string(m_content.substr(0, 200))));
    const bool is_text = boost::algorithm::istarts_with(begin, "solid") &&
                         m_content.substr(0, 1000).find('\0') == std::string_view::npos;
    if(!fits && is_text) {
      read_text();
    } else {
      read_binary(bytes, has_count, count, notes);
    }
  }

private:
  static constexpr std::size_t header_size = 80, triangle_size = 50;

  void read_binary(Binary_data& bytes, const bool has_count, const std::size_t count, Notes& notes)
  {
    const std::size_t found = bytes.size() / triangle_size;
    if(!has_count) {
      throw Input_error(
          "'" + m_model.name +
          "': an STL file begins with 'solid', or is binary and has 84 bytes or more; export the "
          "mesh again");
    }
    if(found != count) {
      throw Input_error(
          "'" + m_model.name + "': the header promises " + count_text(count, "triangle") + ", but the file " +
          (found < count ? "ends after " + std::to_string(found) + ": it was cut short, or the count is wrong"
                         : "has room for " + std::to_string(found)) +
          "; export the mesh again");
    }
    std::size_t colored = 0;
    for(std::size_t t = 0; t < count; ++t) {
      bytes.skip(3 * sizeof(float)); // the normal
      for(int i = 0; i < 3; ++i) {
        std::array<float, 3> point = {};
        for(float& coordinate : point) {
          bytes.read(coordinate);
        }
        add_corner({point[0], point[1], point[2]});
      }
      m_model.end_polygon();
      std::uint16_t attributes = 0;
      bytes.read(attributes);
      colored += attributes != 0;
    }
    if(colored > 0) {
      notes.add("'" + m_model.name + "': outputs are without the attributes, such as colours, of " +
                count_text(colored, "triangle"));
    }
  }

  void read_text()
  {
    bool is_open = false;
    std::size_t vertices = 0;
    for(std::string keyword = word(); !keyword.empty(); keyword = word()) {
      if(keyword == "solid" || keyword == "endsolid") {
        begin_facet();
        is_open = keyword == "solid";
        m_text.lines.rest(); // a name
      } else if(keyword == "vertex") {
        read_vertex(vertices++);
      } else if(keyword == "facet") {
        begin_facet();
      } else if(keyword == "normal") {
        word(), word(), word();
      } else if(keyword == "endfacet") {
        end_facet();
      } else if(keyword != "outer" && keyword != "loop" && keyword != "endloop" && !is_complete()) {
        m_text.refuse(quoted_word(keyword) + " is not a keyword of STL files; export the mesh again");
      }
    }
    if(is_open || corners_of_facet() > 0) {
      m_text.refuse("the file ends without 'endsolid', so it was cut short; export the mesh again");
    }
  }

  // Some programs write 'end loop'.
  std::string word()
  {
    std::string found(m_text.lines.word_in_any_line());
    if(boost::algorithm::iequals(found, "end")) {
      found += m_text.lines.word_in_any_line();
    }
    return boost::algorithm::to_lower_copy(found);
  }

  std::size_t corners_of_facet() const { return m_model.vertices.size() - m_model.first_corners.back(); }

  // Whatever follows the corners of such a facet, up to the next one, does not matter.
  bool is_complete() const { return corners_of_facet() >= 3; }

  // The one before may have no end.
  void begin_facet()
  {
    if(corners_of_facet() > 0) {
      end_facet();
    }
  }

  void end_facet()
  {
    if(!is_complete()) {
      m_text.refuse("the facet has fewer than three vertices; export the mesh again");
    }
    m_model.end_polygon();
  }

  void read_vertex(const std::size_t number)
  {
    std::array<double, 3> point;
    for(double& coordinate : point) {
      coordinate = m_text.coordinate(m_text.lines.word(), number);
    }
    add_corner(point);
  }

  // Coordinates are equal if their bits are: that holds for NaN as well.
  void add_corner(const std::array<double, 3>& point)
  {
    std::array<std::uint64_t, 3> bits;
    for(std::size_t i = 0; i < 3; ++i) {
      const double coordinate =
          std::isnan(point[i]) ? std::numeric_limits<double>::quiet_NaN() : point[i] + 0.; // no negative zero
      std::memcpy(&bits[i], &coordinate, sizeof(coordinate));
    }
    const auto [place, is_new] = m_points.emplace(bits, static_cast<Index>(m_model.points.size()));
    if(is_new) {
      m_model.points.emplace_back(point[0], point[1], point[2]);
    }
    m_model.vertices.push_back(place->second);
  }

  std::string_view m_content;
  Text_reader m_text;
  Model& m_model;
  std::unordered_map<std::array<std::uint64_t, 3>, Index, boost::hash<std::array<std::uint64_t, 3>>> m_points;
};

} // namespace internal

// Reads an STL file. Throws an `Input_error` that names the line, or the counts.
inline void read_stl(const std::string_view content, Model& model, const Degenerate_faces degenerate,
                     Notes& notes)
{
  model.is_welded = true;
  internal::Stl_reader(content, model, degenerate).read(notes);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_STL_H
