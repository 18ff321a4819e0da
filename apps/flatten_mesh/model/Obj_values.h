// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OBJ_VALUES_H
#define FLATTEN_MESH_OBJ_VALUES_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Obj_remarks.h"
#include "flatten_mesh/model/Text_reader.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace flatten_mesh {

// Reads the lines of an OBJ file that contain numbers: points with their colours, texture coordinates, normals.
class Obj_values
{
public:
  Obj_values(Text_reader& text, Model& model, Obj_remarks& remarks)
      : m_text(text), m_lines(text.lines), m_model(model), m_remarks(remarks)
  {}

  void read_vertex()
  {
    std::array<double, 3> coordinates;
    for(double& coordinate : coordinates) {
      coordinate = m_text.coordinate(m_lines.word(), m_model.points.size());
    }
    m_model.points.emplace_back(coordinates[0], coordinates[1], coordinates[2]);
    read_color();
  }

  void read_texture()
  {
    const std::array<double, 3> numbers = read_attribute(1, 2);
    m_model.texture.emplace_back(numbers[0], numbers[1]);
  }

  void read_normal()
  {
    const std::array<double, 3> numbers = read_attribute(3, 3);
    m_model.normals.emplace_back(numbers[0], numbers[1], numbers[2]);
  }

  // Corners forget what does not exist or is not a number.
  void end()
  {
    m_model.colors.resize(m_model.colors.empty() ? 0 : m_model.points.size(), no_color());
    end_corners(m_model.corner_texture, [this](const Index i) {
      return i < m_model.texture.size() && std::isfinite(m_model.texture[i].x());
    });
    end_corners(m_model.corner_normals, [this](const Index i) {
      return i < m_model.normals.size() && std::isfinite(m_model.normals[i].x());
    });
  }

private:
  static Point_color no_color()
  {
    const double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none, none, 1};
  }

  // Three further numbers; a single one is the weight of rational curves.
  void read_color()
  {
    Point_color color = no_color();
    std::size_t numbers = 0;
    bool is_right = true;
    for(std::string_view word = m_lines.word(); !word.empty(); word = m_lines.word()) {
      is_right = is_right && numbers < 4 && read_finite_number(word, color[numbers]);
      ++numbers;
    }
    if(numbers < 3) {
      return;
    }
    if(!is_right) {
      m_remarks.ignore_attribute(m_lines.number());
      return;
    }
    m_model.colors.resize(m_model.points.size() - 1, no_color());
    m_model.colors.push_back(color);
  }

  // Of texture coordinates or a normal; NaN if they are no numbers.
  std::array<double, 3> read_attribute(const std::size_t at_least, const std::size_t at_most)
  {
    std::array<double, 3> numbers = {0, 0, 0};
    for(std::size_t i = 0; i < at_most; ++i) {
      const std::string_view word = m_lines.word();
      if(word.empty() ? i < at_least : !read_finite_number(word, numbers[i])) {
        m_remarks.ignore_attribute(m_lines.number());
        numbers[0] = std::numeric_limits<double>::quiet_NaN();
        return numbers;
      }
      if(word.empty()) {
        return numbers;
      }
    }
    return numbers;
  }

  template <class Exists>
  void end_corners(std::vector<Index>& corners, const Exists& exists)
  {
    if(corners.empty()) {
      return;
    }
    corners.resize(m_model.vertices.size(), no_index);
    for(Index& index : corners) {
      if(index != no_index && !exists(index)) {
        index = no_index;
        m_remarks.miss_attribute();
      }
    }
  }

  Text_reader& m_text;
  Text_lines& m_lines;
  Model& m_model;
  Obj_remarks& m_remarks;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OBJ_VALUES_H
