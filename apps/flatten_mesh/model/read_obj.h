// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_OBJ_H
#define FLATTEN_MESH_READ_OBJ_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Obj_remarks.h"
#include "flatten_mesh/model/Obj_values.h"
#include "flatten_mesh/model/Text_reader.h"
#include "flatten_mesh/model/own_marks.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Reads an OBJ file. CGAL's reader supports only a part of the format, and does not report the line that it does not
// understand.
class Obj_reader
{
public:
  Obj_reader(const std::string_view text, Model& model, const Degenerate_faces degenerate)
      : m_text(text, model, degenerate, Text_lines::BACKSLASHES), m_lines(m_text.lines), m_model(model),
        m_values(m_text, model, m_remarks), m_keeps_all(m_text.keeps_all()),
        m_is_own(text.rfind(first_obj_line, 0) == 0)
  {}

  void read(Notes& notes)
  {
    while(m_lines.next()) {
      read_line();
    }
    if(m_model.number_of_polygons() == 0) {
      refuse_empty_file();
    }
    if(m_end_of_indices > static_cast<long long>(m_model.points.size())) {
      m_text.refuse_at(m_line_of_largest,
                       "the " + m_element_of_largest + " names vertex " + std::to_string(m_end_of_indices) +
                           ", which does not exist: the file has only " +
                           std::to_string(m_model.points.size()) + "; export the mesh again");
    }
    m_values.end();
    if(m_is_own) {
      forget_common_texture();
    }
    m_remarks.tell_skipped(m_model.name, notes);
    if(m_keeps_all) {
      m_remarks.tell_attributes(m_model.name, notes);
    }
  }

private:
  void read_line()
  {
    const std::string keyword(m_lines.word());
    if(keyword == "v") {
      m_values.read_vertex();
    } else if(keyword == "vt") {
      m_values.read_texture();
    } else if(keyword == "vn") {
      m_values.read_normal();
    } else if(keyword == "f" || keyword == "fo") {
      read_face();
    } else if(m_keeps_all && (keyword == "l" || keyword == "p")) {
      read_lines_or_points(keyword);
    } else if(is_kept(keyword)) {
      read_statement(keyword);
    } else if(!keyword.empty() && keyword != "vp") {
      m_remarks.skip_line(m_lines.number(), keyword);
    }
  }

  void read_face()
  {
    const std::size_t first = m_model.vertices.size();
    for(std::string_view word = m_lines.word(); !word.empty(); word = m_lines.word()) {
      read_corner(word);
    }
    const std::size_t size = m_model.vertices.size() - first;
    if(size < (m_keeps_all ? 1 : 3)) {
      refuse(size == 0 ? "the face has no vertices; remove it"
                       : "the face has fewer than three vertices; remove it");
    }
    if(!m_keeps_all) {
      check_corners(first);
    }
    if(!m_model.material_names.empty()) {
      m_model.materials.resize(m_model.number_of_polygons(), no_index);
      m_model.materials.push_back(m_material);
    }
    m_model.end_polygon();
  }

  void check_corners(const std::size_t first)
  {
    m_sorted.assign(m_model.vertices.begin() + static_cast<std::ptrdiff_t>(first), m_model.vertices.end());
    m_sorted.erase(std::unique(m_sorted.begin(), m_sorted.end()), m_sorted.end());
    if(m_sorted.size() > 3 && m_sorted.front() == m_sorted.back()) {
      m_sorted.pop_back();
    }
    if(m_sorted.size() < 3) { // then a vertex twice in a row is not one corner
      m_sorted.assign(m_model.vertices.begin() + static_cast<std::ptrdiff_t>(first), m_model.vertices.end());
    }
    std::sort(m_sorted.begin(), m_sorted.end());
    const auto twice = std::adjacent_find(m_sorted.begin(), m_sorted.end());
    if(twice != m_sorted.end()) {
      refuse("the face names " + vertex_name(*twice) + " twice; remove degenerate faces");
    }
  }

  // In files of this program, faces without coordinates have the same ones at all their points.
  void forget_common_texture()
  {
    for(Index p = 0; p < m_model.number_of_polygons() && !m_model.corner_texture.empty(); ++p) {
      const auto is_common = [&, first = m_model.first_corners[p]](const std::vector<Index>& corners) {
        return std::all_of(corners.begin() + first, corners.begin() + m_model.first_corners[p + 1],
                           [&](const Index number) { return number == corners[first]; });
      };
      if(is_common(m_model.corner_texture) && !is_common(m_model.vertices)) {
        std::fill(m_model.corner_texture.begin() + m_model.first_corners[p],
                  m_model.corner_texture.begin() + m_model.first_corners[p + 1], no_index);
      }
    }
  }

  // Such as '7', '7/3', '7//2' or '-1/-1/-1'
  void read_corner(const std::string_view word)
  {
    const std::size_t slash = word.find('/'),
                      second = slash == word.npos ? word.npos : word.find('/', slash + 1);
    m_model.vertices.push_back(vertex_index(word));
    if(slash != word.npos && second != slash + 1) {
      read_attribute_index(word.substr(slash + 1, second - slash - 1), m_model.texture.size(),
                           m_model.corner_texture);
    }
    if(second != word.npos) {
      read_attribute_index(word.substr(second + 1), m_model.normals.size(), m_model.corner_normals);
    }
  }

  // Of texture coordinates or a normal, at the last corner. Those that do not exist are noticed in the end.
  void read_attribute_index(const std::string_view word, const std::size_t before,
                            std::vector<Index>& corners)
  {
    long long index = 0;
    if(!read_obj_index(word, before, index) || index < 0 || index >= no_index) {
      m_remarks.ignore_attribute(m_lines.number());
      return;
    }
    corners.resize(m_model.vertices.size() - 1, no_index);
    corners.push_back(static_cast<Index>(index));
  }

  // Of the word of a corner
  Index vertex_index(const std::string_view word)
  {
    const std::string_view digits = word.substr(0, word.find('/'));
    const std::string begin = std::string("the ") + m_element + " names ";
    const std::size_t before = m_model.points.size();
    long long index = 0;
    if(digits == "0") {
      refuse(begin + "vertex 0, but vertices are counted from 1; export the mesh again");
    }
    if(!read_obj_index(digits, before, index)) {
      refuse(begin + quoted_word(word) + ", which is not the number of a vertex; export the mesh again");
    }
    if(index < 0) {
      refuse(begin + "vertex " + std::string(digits) + ", counted backwards, but only " +
             count_text(before, "vertex", "vertices") + " come before it; export the mesh again");
    }
    if(index >= m_end_of_indices) {
      m_end_of_indices = index + 1;
      m_line_of_largest = m_lines.number();
      m_element_of_largest = m_element;
    }
    return static_cast<Index>((std::min)(index, static_cast<long long>(no_index)));
  }

  // Its vertices are counted from 1 then: texture coordinates will have other numbers.
  void read_lines_or_points(const std::string& keyword)
  {
    m_element = keyword == "l" ? "line" : "point";
    std::string text = keyword;
    for(std::string_view word = m_lines.word(); !word.empty(); word = m_lines.word()) {
      text += ' ';
      append_number(text, vertex_index(word) + 1);
    }
    m_element = "face";
    add_statement(text);
  }

  void read_statement(const std::string& keyword)
  {
    const std::string rest = m_lines.rest();
    add_statement(rest.empty() ? keyword : keyword + " " + rest);
    if(keyword == "usemtl") {
      m_material = no_index;
      if(!rest.empty()) {
        const auto number = static_cast<Index>(m_model.material_names.size());
        const auto [place, is_new] = m_material_numbers.emplace(rest, number);
        m_material = place->second;
        if(is_new) {
          m_model.material_names.push_back(rest);
        }
      }
    }
  }

  void add_statement(const std::string& text)
  {
    m_model.statements.push_back({static_cast<Index>(m_model.number_of_polygons()), text});
  }

  // Groups, objects, smoothing groups, materials, display
  static bool is_kept(const std::string& keyword)
  {
    static const std::array<const char*, 11> known = {
        "g", "o", "s", "mg", "lod", "usemtl", "mtllib", "usemap", "maplib", "c_interp", "d_interp"};
    return std::find(known.begin(), known.end(), keyword) != known.end();
  }

  [[noreturn]] void refuse(const std::string& what) const { m_text.refuse(what); }

  [[noreturn]] void refuse_empty_file() const
  {
    throw Input_error("'" + m_model.name + "': the file has " +
                      (m_model.points.empty()
                           ? "no vertices; export the mesh again"
                           : "vertices but no faces; a point cloud has to be made into a surface first") +
                      m_remarks.first_skipped());
  }

  Text_reader m_text;
  Text_lines& m_lines;
  Model& m_model;
  Obj_remarks m_remarks;
  Obj_values m_values;
  bool m_keeps_all;
  bool m_is_own; // written by this program
  std::vector<Index> m_sorted;
  std::unordered_map<std::string, Index> m_material_numbers;
  Index m_material = no_index;
  const char* m_element = "face"; // that names vertices
  long long m_end_of_indices = 0;
  std::size_t m_line_of_largest = 0;
  std::string m_element_of_largest;
};

} // namespace internal

// Reads an OBJ file. Throws an `Input_error` with the number of the line that is wrong.
inline void read_obj(const std::string_view text, Model& model, const Degenerate_faces degenerate,
                     Notes& notes)
{
  internal::Obj_reader(text, model, degenerate).read(notes);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_OBJ_H
