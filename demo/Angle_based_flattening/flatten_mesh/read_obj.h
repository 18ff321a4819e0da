// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_OBJ_H
#define FLATTEN_MESH_READ_OBJ_H

#include "Notes.h"
#include "Polygon_soup.h"
#include "texts.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <istream>
#include <string>
#include <system_error>

namespace flatten_mesh {

namespace internal {

// Reads vertices and faces of an OBJ file. CGAL's reader supports only a part of the format, and does not report the
// line that it does not understand.
class Obj_reader
{
public:
  Obj_reader(const std::string& name, Polygon_soup& soup) : m_name(name), m_soup(soup) {}

  void read(std::istream& file, Notes& notes)
  {
    while(next_line(file)) {
      const std::string keyword = next_word();
      if(keyword == "v") {
        read_vertex();
      } else if(keyword == "f" || keyword == "fo") {
        read_face();
      } else if(!keyword.empty() && !is_without_meaning(keyword) && m_skipped++ == 0) {
        m_first_skipped =
            "line " + std::to_string(m_number) + ", which begins with '" + keyword.substr(0, 20) + "'";
      }
    }
    if(m_soup.polygons.empty()) {
      refuse_empty_file();
    }
    if(m_largest_index > m_soup.points.size()) {
      throw Input_error("'" + m_name + "', line " + std::to_string(m_line_of_largest) +
                        ": the face names vertex " + std::to_string(m_largest_index) +
                        ", which does not exist: the file has only " + std::to_string(m_soup.points.size()) +
                        "; export the mesh again");
    }
    if(m_skipped > 0) {
      notes.add("'" + m_name + "': " + count_text(m_skipped, "line") +
                " not understood and skipped: " + (m_skipped > 1 ? "the first is " : "") + m_first_skipped);
    }
  }

private:
  // One line with its continuation lines. Its number is that of the first.
  bool next_line(std::istream& file)
  {
    m_line.clear();
    m_position = 0;
    m_number += m_lines_taken;
    m_lines_taken = 0;
    std::string part;
    bool continues = true;
    while(continues && std::getline(file, part)) {
      ++m_lines_taken;
      if(!part.empty() && part.back() == '\r') {
        part.pop_back();
      }
      continues = !part.empty() && part.back() == '\\';
      if(continues) {
        part.back() = ' ';
      }
      m_line += part;
    }
    return m_lines_taken > 0;
  }

  // Empty at the end of the line, or where a comment begins
  std::string next_word()
  {
    const auto is_blank = [](const char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    const auto begin = std::find_if_not(m_line.begin() + m_position, m_line.end(), is_blank);
    const auto end = std::find_if(begin, m_line.end(), is_blank);
    m_position = end - m_line.begin();
    return begin != end && *begin == '#' ? std::string() : std::string(begin, end);
  }

  void read_vertex()
  {
    std::array<double, 3> coordinates;
    for(double& coordinate : coordinates) {
      const std::string word = next_word();
      if(word.empty()) {
        refuse("a vertex has fewer than three coordinates; export the mesh again");
      }
      char* end = nullptr;
      coordinate = std::strtod(word.c_str(), &end);
      if(*end != '\0' || !std::isfinite(coordinate)) {
        refuse("the coordinate '" + word + "' is not a finite number; remove the vertex or repair the scan");
      }
    }
    m_soup.points.emplace_back(coordinates[0], coordinates[1], coordinates[2]);
  }

  void read_face()
  {
    Polygon polygon;
    for(std::string word = next_word(); !word.empty(); word = next_word()) {
      polygon.push_back(vertex_index(word));
    }
    if(polygon.size() < 3) {
      refuse("the face has fewer than three vertices; remove it");
    }
    Polygon sorted(polygon);
    std::sort(sorted.begin(), sorted.end());
    const Polygon::const_iterator twice = std::adjacent_find(sorted.begin(), sorted.end());
    if(twice != sorted.end()) {
      refuse("the face names " + vertex_name(*twice) + " twice; remove degenerate faces");
    }
    m_soup.polygons.push_back(polygon);
  }

  // Of a corner such as '7', '7/3', '7//2' or '-1/-1': counted from 1, or backwards from the last vertex before the face.
  std::size_t vertex_index(const std::string& word)
  {
    long long number = 0;
    const char* const end = word.data() + word.size();
    const std::from_chars_result result = std::from_chars(word.data(), end, number);
    if(result.ec != std::errc() || (result.ptr != end && *result.ptr != '/')) {
      refuse("the face names '" + word + "', which is not the number of a vertex; export the mesh again");
    }
    if(number == 0) {
      refuse("the face names vertex 0, but vertices are counted from 1; export the mesh again");
    }
    const auto before = static_cast<long long>(m_soup.points.size());
    if(number < -before) {
      refuse("the face names vertex " + std::to_string(number) + ", counted backwards, but only " +
             count_text(m_soup.points.size(), "vertex", "vertices") +
             " come before it; export the mesh again");
    }
    const auto index = static_cast<std::size_t>(number < 0 ? before + number : number - 1);
    if(index + 1 > m_largest_index) {
      m_largest_index = index + 1;
      m_line_of_largest = m_number;
    }
    return index;
  }

  // Whether a keyword says nothing about the surface: comments, normals, texture, groups, materials, display.
  static bool is_without_meaning(const std::string& keyword)
  {
    static const std::array<const char*, 14> known = {"vt",     "vn",     "vp",       "g",       "o",
                                                      "s",      "mg",     "lod",      "usemtl",  "mtllib",
                                                      "usemap", "maplib", "c_interp", "d_interp"};
    return std::find(known.begin(), known.end(), keyword) != known.end();
  }

  [[noreturn]] void refuse(const std::string& what) const
  {
    throw Input_error("'" + m_name + "', line " + std::to_string(m_number) + ": " + what);
  }

  [[noreturn]] void refuse_empty_file() const
  {
    throw Input_error("'" + m_name + "': the file has " +
                      (m_soup.points.empty()
                           ? "no vertices; export the mesh again"
                           : "vertices but no faces; a point cloud has to be made into a surface first") +
                      (m_skipped > 0 ? " (" + m_first_skipped + ", was not understood)" : ""));
  }

  std::string m_name;
  Polygon_soup& m_soup;
  std::string m_line;
  std::ptrdiff_t m_position = 0;
  std::size_t m_number = 1; // of the line, from 1
  std::size_t m_lines_taken = 0;
  std::size_t m_skipped = 0;
  std::string m_first_skipped;
  std::size_t m_largest_index = 0; // from 1
  std::size_t m_line_of_largest = 0;
};

} // namespace internal

// Appends the vertices and faces of an OBJ file. Throws an `Input_error` with the number of the line that is wrong.
inline void read_obj(std::istream& file, const std::string& name, Polygon_soup& soup, Notes& notes)
{
  internal::Obj_reader(name, soup).read(file, notes);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_OBJ_H
