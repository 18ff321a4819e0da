// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_OFF_H
#define FLATTEN_MESH_READ_OFF_H

#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Text_reader.h"
#include "flatten_mesh/texts.h"

#include <CGAL/IO/OFF/File_scanner_OFF.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Reads an OFF file: points, their normals, colours and texture coordinates, polygons. CGAL's reader needs each vertex
// and face in a line of its own, does not report the line that it does not understand, and believes all counts.
class Off_reader
{
public:
  Off_reader(const std::string_view text, Model& model, const Degenerate_faces degenerate)
      : m_text(text, model, degenerate), m_model(model)
  {}

  void read(Notes& notes)
  {
    read_header();
    for(std::size_t v = 0; v < m_vertices; ++v) {
      read_vertex(v);
    }
    for(std::size_t f = 0; f < m_faces; ++f) {
      read_face(f);
    }
    m_model.has_point_normals = m_has_normals;
    m_model.has_point_texture = m_has_texture;
    if(m_colored_faces > 0) {
      notes.add("'" + m_model.name + "': outputs are without the colours of " +
                count_text(m_colored_faces, "face"));
    }
  }

private:
  void read_header()
  {
    const std::string_view first = m_text.lines.word_in_any_line();
    const std::size_t off = first.find("OFF");
    if(off == first.npos || first.find_first_not_of("STCN4") < off) {
      refuse_header();
    }
    const std::string_view kind = first.substr(0, off), count = first.substr(off + 3);
    m_has_texture = kind.find("ST") != kind.npos;
    m_has_colors = kind.find('C') != kind.npos;
    m_has_normals = kind.find('N') != kind.npos;
    m_is_homogeneous = kind.find('4') != kind.npos;
    // ModelNet's files have the first count without a space before it.
    std::string_view word = count.empty() ? m_text.lines.word_in_any_line() : count;
    if(word == "BINARY") {
      m_text.refuse("binary OFF files are not read; export the mesh as PLY");
    }
    const bool has_vertices = read_count(word, m_vertices),
               has_faces = has_vertices && read_count(m_text.lines.word_in_any_line(), m_faces);
    std::size_t edges = 0;
    const std::size_t line = m_text.lines.number();
    word = has_faces ? m_text.lines.word_in_any_line() : std::string_view();
    const bool is_elsewhere = m_text.lines.number() != line;
    if(!read_count(word, edges) || (is_elsewhere && !m_text.lines.word().empty())) {
      m_text.refuse_at(line, header_text());
    }
  }

  static std::string header_text()
  {
    return "an OFF file begins with OFF and the numbers of its vertices, faces and edges; export the mesh "
           "again";
  }

  [[noreturn]] void refuse_header() const { m_text.refuse(header_text()); }

  void read_vertex(const std::size_t v)
  {
    if(!m_text.next_item(m_words)) {
      refuse_end();
    }
    const std::size_t line = m_text.lines.number(),
                      needed = std::size_t(3) + m_is_homogeneous + 3 * m_has_normals + 2 * m_has_texture;
    const bool is_divided = m_words.size() < needed;
    if(is_divided && !is_whole(line, v, needed)) {
      m_text.refuse_at(line, vertex_name(v) + " has fewer than three coordinates" +
                                 (needed > 3 ? ", or normals and texture coordinates" : "") +
                                 "; export the mesh again");
    }
    std::array<double, 4> point = {0, 0, 0, 1};
    for(std::size_t i = 0; i < (m_is_homogeneous ? 4u : 3u); ++i) {
      point[i] = m_text.coordinate(m_words[i], v);
    }
    m_model.points.emplace_back(point[0] / point[3], point[1] / point[3], point[2] / point[3]);
    read_attributes(v, m_is_homogeneous ? 4 : 3);
  }

  // Reads the rest of a vertex. Whether it ends with a line: otherwise some of its numbers are missing.
  bool is_whole(const std::size_t line, const std::size_t v, const std::size_t needed)
  {
    for(std::size_t i = 0; i < (std::min)(m_words.size(), std::size_t(3)); ++i) {
      m_text.coordinate(m_words[i], v); // a message names this line
    }
    if(!m_text.complete_item(m_words, needed)) {
      m_text.refuse_at(line, vertex_name(v) +
                                 " has fewer than three coordinates: the file ends here, so it was cut "
                                 "short; export the mesh again");
    }
    return m_words.size() == needed;
  }

  // In the words after the coordinates: the normal, the colour, the texture coordinates
  void read_attributes(const std::size_t v, std::size_t next)
  {
    std::size_t end = m_words.size();
    if(m_has_normals) {
      m_model.normals.emplace_back(number(next, v), number(next + 1, v), number(next + 2, v));
      next += 3;
    }
    if(m_has_texture) {
      end = m_has_colors ? end : next + 2;
      m_model.texture.emplace_back(number(end - 2, v), number(end - 1, v));
      end -= 2;
    }
    if(m_has_colors) {
      m_model.colors.push_back(color(next, end - next, v));
    }
  }

  double number(const std::size_t i, const std::size_t v) const
  {
    double result = 0;
    if(!read_number(m_words[i], result)) {
      m_text.refuse("the value " + quoted_word(m_words[i]) + " of " + vertex_name(v) +
                    " is not a number; export the mesh again");
    }
    return result;
  }

  // Whole numbers are up to 255, others up to 1, and a single one is that of a colour in a list of CGAL's.
  Point_color color(const std::size_t first, const std::size_t count, const std::size_t v) const
  {
    const double none = std::numeric_limits<double>::quiet_NaN();
    Point_color result = {none, none, none, 1};
    std::size_t index = 0;
    if(count == 1 && read_count(m_words[first], index) && index < 149) {
      const CGAL::IO::Color& known = CGAL::File_scanner_OFF::get_indexed_color(static_cast<int>(index));
      return {known.red() / 255., known.green() / 255., known.blue() / 255., known.alpha() / 255.};
    }
    if(count == 3 || count == 4) {
      bool is_whole = true;
      for(std::size_t i = 0; i < count; ++i) {
        result[i] = number(first + i, v);
        is_whole = is_whole && m_words[first + i].find_first_of(".eE") == std::string_view::npos;
      }
      for(std::size_t i = 0; i < count && is_whole; ++i) {
        result[i] /= 255;
      }
    }
    return result;
  }

  void read_face(const std::size_t f)
  {
    if(!m_text.next_item(m_words)) {
      refuse_end();
    }
    const std::size_t line = m_text.lines.number();
    std::size_t size = 0;
    if(!read_count(m_words[0], size)) {
      m_text.refuse(face_name(f) + " begins with " + quoted_word(m_words[0]) +
                    ", which is not the number of its vertices; export the mesh again");
    }
    if(size == 0) {
      m_text.refuse(face_name(f) + " has no vertices; remove it");
    }
    if(size >= no_index || !m_text.complete_item(m_words, size + 1)) {
      m_text.refuse_at(line, face_name(f) + " has fewer vertices than its count, " + std::to_string(size) +
                                 ", says: the file ends here, so it was cut short; export the mesh again");
    }
    for(std::size_t i = 1; i <= size; ++i) {
      std::size_t index = 0;
      if(!read_count(m_words[i], index) || index >= m_vertices) {
        m_text.refuse_at(line, face_name(f) + " names vertex " + quoted_word(m_words[i]) +
                                   " (counted from 0), which does not exist: the file has only " +
                                   std::to_string(m_vertices) + "; export the mesh again");
      }
      m_model.vertices.push_back(static_cast<Index>(index));
    }
    m_colored_faces += m_words.size() > size + 1;
    m_model.end_polygon();
  }

  [[noreturn]] void refuse_end() const
  {
    throw Input_error("'" + m_model.name + "': the header promises " +
                      count_text(m_vertices, "vertex", "vertices") + " and " + count_text(m_faces, "face") +
                      ", but the file ends after line " + std::to_string(m_text.lines.number() - 1) +
                      " with " + std::to_string(m_model.points.size()) + " and " +
                      std::to_string(m_model.number_of_polygons()) +
                      ": it was cut short, or the counts are wrong; export the mesh again");
  }

  Text_reader m_text;
  Model& m_model;
  bool m_has_texture = false, m_has_colors = false, m_has_normals = false, m_is_homogeneous = false;
  std::size_t m_vertices = 0, m_faces = 0; // as the header says
  std::size_t m_colored_faces = 0;
  std::vector<std::string_view> m_words;
};

} // namespace internal

// Reads an OFF file. Throws an `Input_error` with the number of the line that is wrong.
inline void read_off(const std::string_view text, Model& model, const Degenerate_faces degenerate,
                     Notes& notes)
{
  internal::Off_reader(text, model, degenerate).read(notes);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_OFF_H
