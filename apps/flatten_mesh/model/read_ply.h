// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_PLY_H
#define FLATTEN_MESH_READ_PLY_H

#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Ply_header.h"
#include "flatten_mesh/model/Ply_items.h"
#include "flatten_mesh/model/Text_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Reads a PLY file. CGAL's reader drops normals and texture coordinates, knows no strips, and believes all counts.
class Ply_reader
{
public:
  Ply_reader(const std::string_view content, Model& model, const Degenerate_faces degenerate, Notes& notes)
      : m_text(content, model, degenerate), m_model(model), m_notes(notes),
        m_header(Ply_header_reader(m_text).read()), m_items(content, m_text, m_header, model)
  {}

  void read()
  {
    for(const Ply_element& element : m_header.elements) {
      if(element.is_named("vertex", "vertices")) {
        read_vertices(element);
      } else if(element.is_named("face", "faces")) {
        read_faces(element);
      } else if(element.is_named("tristrips", "tristrip")) {
        read_strips(element);
      } else if(!element.properties.empty()) {
        for(std::size_t i = 0; i < element.count; ++i) {
          m_items.read(element, i);
        }
        tell_left_out(element, {});
      }
    }
    if(!m_model.corner_texture.empty()) {
      m_model.corner_texture.resize(m_model.number_of_corners(), no_index);
    }
    if(!m_left_out.empty()) {
      m_notes.add("'" + m_model.name + "': outputs are without these properties: " + m_left_out);
    }
    if(m_header.names_textures) {
      m_notes.add("'" + m_model.name + "': outputs are without the names of textures in its header");
    }
  }

private:
  using Columns = std::vector<std::size_t>; // numbers of properties

  static Columns columns(const Ply_element& element, const std::initializer_list<const char*>& names)
  {
    Columns result;
    for(const char* name : names) {
      const std::size_t k = element.find(name);
      if(k == element.properties.size() || element.properties[k].is_list) {
        return {};
      }
      result.push_back(k);
    }
    return result;
  }

  static Columns first_columns(const Ply_element& element,
                               const std::initializer_list<std::initializer_list<const char*>>& all_names)
  {
    for(const auto& names : all_names) {
      const Columns result = columns(element, names);
      if(!result.empty()) {
        return result;
      }
    }
    return {};
  }

  // Remembers which properties of an element are not read.
  void tell_left_out(const Ply_element& element, const Columns& read)
  {
    std::string names;
    for(std::size_t k = 0; k < element.properties.size(); ++k) {
      if(std::find(read.begin(), read.end(), k) == read.end()) {
        names += (names.empty() ? "" : ", ") + element.properties[k].name;
      }
    }
    if(!names.empty() && element.count > 0) {
      m_left_out += (m_left_out.empty() ? "" : "; ") + names + " of '" + element.name + "'";
    }
  }

  // All names of texture coordinates of vertices that an element has
  static std::vector<Columns> texture_columns(const Ply_element& element)
  {
    static const std::array<std::array<const char*, 2>, 3> known = {
        {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}};
    std::vector<Columns> result;
    for(const auto& names : known) {
      if(Columns found = columns(element, {names[0], names[1]}); !found.empty()) {
        result.push_back(std::move(found));
      }
    }
    return result;
  }

  // Of some columns, those whose values in the last item are equal to those of the given ones
  void keep_equal(const Columns& given, std::vector<Columns>& all) const
  {
    const auto is_other = [&](const Columns& other) {
      return !std::equal(given.begin(), given.end(), other.begin(), [this](const auto a, const auto b) {
        return m_items.numbers[a] == m_items.numbers[b];
      });
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_other), all.end());
  }

  void read_vertices(const Ply_element& element)
  {
    const Columns points = columns(element, {"x", "y", "z"}), normals = columns(element, {"nx", "ny", "nz"}),
                  texture = m_model.texture.empty() && !texture_columns(element).empty()
                                ? texture_columns(element).front()
                                : Columns(), // of corners
        colors = first_columns(
            element, {{"red", "green", "blue", "alpha"}, {"red", "green", "blue"}, {"r", "g", "b"}});
    if(points.empty() || !m_model.points.empty()) {
      refuse_header(points.empty() ? "its vertices have no properties 'x', 'y' and 'z'"
                                   : "it declares vertices twice");
    }
    std::vector<Columns> others = texture.empty() ? std::vector<Columns>() : texture_columns(element);
    for(std::size_t j = 0; j < element.count; ++j) {
      m_items.read(element, j);
      keep_equal(texture, others);
      const auto value = [this](const std::size_t column) { return m_items.numbers[column][0]; };
      m_model.points.emplace_back(value(points[0]), value(points[1]), value(points[2]));
      if(!m_text.keeps_all()) {
        check_finite(points);
      }
      if(!normals.empty()) {
        m_model.normals.emplace_back(value(normals[0]), value(normals[1]), value(normals[2]));
      }
      if(!texture.empty()) {
        m_model.texture.emplace_back(value(texture[0]), value(texture[1]));
      }
      if(!colors.empty()) {
        m_model.colors.push_back(color(element, colors));
      }
    }
    m_model.has_point_normals = !m_model.normals.empty();
    m_model.has_point_texture = !texture.empty();
    Columns read = points;
    others.insert(others.end(), {normals, texture, colors});
    for(const Columns& more : others) {
      read.insert(read.end(), more.begin(), more.end());
    }
    tell_left_out(element, read);
  }

  void check_finite(const Columns& points) const
  {
    for(const std::size_t k : points) {
      if(!std::isfinite(m_items.numbers[k][0])) {
        m_items.refuse(" has a coordinate that is not a finite number; remove it or repair the scan");
      }
    }
  }

  // Whole numbers are scaled to at most 1.
  Point_color color(const Ply_element& element, const Columns& columns) const
  {
    static const std::array<double, 8> largest = {127,        255,        32767,  65535,
                                                  2147483647, 4294967295, 9.2e18, 1.8e19};
    Point_color result = {0, 0, 0, 1};
    for(std::size_t i = 0; i < columns.size(); ++i) {
      const auto type = static_cast<std::size_t>(element.properties[columns[i]].type);
      result[i] = m_items.numbers[columns[i]][0] / (type < largest.size() ? largest[type] : 1);
    }
    return result;
  }

  // The property with the vertices of faces or strips
  std::size_t list_of_vertices(const Ply_element& element) const
  {
    const std::size_t k = (std::min)(element.find("vertex_indices"), element.find("vertex_index"));
    if(k == element.properties.size() || !element.properties[k].is_list) {
      refuse_header("'" + element.name + "' has no list 'vertex_indices'");
    }
    return k;
  }

  void read_faces(const Ply_element& element)
  {
    const std::size_t vertices = list_of_vertices(element), texture = element.find("texcoord");
    if(texture < element.properties.size()) {
      ignore_equal_texture_of_points();
    }
    tell_left_out(element, {vertices, texture, element.find("chart")}); // our own charts are made anew
    for(std::size_t j = 0; j < element.count; ++j) {
      m_items.read(element, j);
      const std::size_t first = m_model.vertices.size();
      for(const double index : m_items.numbers[vertices]) {
        m_model.vertices.push_back(vertex(index));
      }
      if(m_model.vertices.size() == first) {
        m_items.refuse(" has no vertices; remove it");
      }
      if(!m_model.has_point_texture && texture < element.properties.size()) {
        add_texture(m_items.numbers[texture], first);
      }
      m_model.end_polygon();
    }
    if(m_header.is_own && m_model.has_point_texture) {
      forget_zeros_of_points();
    }
  }

  // Faces without coordinates have vertices of their own, with zeros.
  void forget_zeros_of_points()
  {
    std::vector<Kernel::Point_2>& uv = m_model.texture;
    std::vector<bool> is_known(uv.size(), false);
    for(Index p = 0; p < m_model.number_of_polygons(); ++p) {
      const auto first = m_model.vertices.begin() + m_model.first_corners[p],
                 end = m_model.vertices.begin() + m_model.first_corners[p + 1];
      if(!std::all_of(first, end, [&](const Index v) { return uv[v] == Kernel::Point_2(0, 0); })) {
        std::for_each(first, end, [&is_known](const Index v) { is_known[v] = true; });
      }
    }
    const double none = std::numeric_limits<double>::quiet_NaN();
    for(std::size_t v = 0; v < uv.size(); ++v) {
      uv[v] = is_known[v] ? uv[v] : Kernel::Point_2(none, none);
    }
  }

  // Some programs write zeros for each vertex, beside the coordinates of corners.
  void ignore_equal_texture_of_points()
  {
    const std::vector<Kernel::Point_2>& uv = m_model.texture;
    if(m_model.has_point_texture && uv.size() > 1 &&
       std::all_of(uv.begin(), uv.end(), [&uv](const Kernel::Point_2& p) { return p == uv[0]; })) {
      m_model.texture.clear();
      m_model.has_point_texture = false;
      m_notes.add(
          "'" + m_model.name +
          "': the texture coordinates of all vertices are equal, so that those of the faces are taken");
    }
  }

  // Texture coordinates of the corners of the last polygon, as two numbers each
  void add_texture(const std::vector<double>& numbers, const std::size_t first)
  {
    const auto is_zero = [](const double number) { return number == 0; };
    if(numbers.size() != 2 * (m_model.vertices.size() - first) ||
       (m_header.is_own && std::all_of(numbers.begin(), numbers.end(), is_zero))) {
      return;
    }
    m_model.corner_texture.resize(first, no_index);
    for(std::size_t i = 0; i < numbers.size(); i += 2) {
      m_model.corner_texture.push_back(static_cast<Index>(m_model.texture.size()));
      m_model.texture.emplace_back(numbers[i], numbers[i + 1]);
    }
  }

  // Every other triangle of a strip is turned. -1 begins a new one; a vertex twice only leads the strip elsewhere.
  void read_strips(const Ply_element& element)
  {
    const std::size_t vertices = list_of_vertices(element);
    tell_left_out(element, {vertices});
    for(std::size_t j = 0; j < element.count; ++j) {
      m_items.read(element, j);
      const std::vector<double>& numbers = m_items.numbers[vertices];
      std::size_t first = 0;
      for(std::size_t i = 0; i < numbers.size(); ++i) {
        if(numbers[i] == -1) {
          first = i + 1;
        } else if(const Index v = vertex(numbers[i]); i >= first + 2) {
          const Index before = vertex(numbers[i - 1]), second = vertex(numbers[i - 2]);
          if(v != before && before != second && second != v) {
            const bool is_turned = (i - first) % 2 == 1;
            m_model.vertices.insert(m_model.vertices.end(),
                                    {is_turned ? before : second, is_turned ? second : before, v});
            m_model.end_polygon();
          }
        }
      }
    }
  }

  // Points may also come later.
  Index vertex(const double index) const
  {
    const auto most = static_cast<double>(m_model.points.empty() ? no_index : m_model.points.size());
    if(!(index >= 0 && index < most && index == std::floor(index))) {
      m_items.refuse(" names vertex '" + format_number("%.10g", index) +
                     "' (counted from 0), which does not exist: the file has only " +
                     std::to_string(m_model.points.size()) + "; export the mesh again");
    }
    return static_cast<Index>(index);
  }

  [[noreturn]] void refuse_header(const std::string& what) const
  {
    throw Input_error("'" + m_model.name + "': the header of the file is wrong: " + what +
                      "; export the mesh again");
  }

  Text_reader m_text;
  Model& m_model;
  Notes& m_notes;
  std::string m_left_out;
  Ply_header m_header;
  Ply_items m_items;
};

} // namespace internal

// Reads a PLY file: points, their colours, normals and texture coordinates, polygons or strips of triangles, and the
// texture coordinates of corners. Throws an `Input_error` that names what is wrong.
inline void read_ply(const std::string_view content, Model& model, const Degenerate_faces degenerate,
                     Notes& notes)
{
  internal::Ply_reader(content, model, degenerate, notes).read();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_PLY_H
