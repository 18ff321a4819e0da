// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_MODEL_OBJ_H
#define FLATTEN_MESH_WRITE_MODEL_OBJ_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/model/Shared_uv.h"
#include "flatten_mesh/model/material_files.h"
#include "flatten_mesh/model/own_marks.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

// Writes the lines of an OBJ file, a part of the text at a time. Some programs refuse a file, or drop all coordinates, if
// a face has none, and others if it has a material of its own instead. Therefore all corners of such faces share a `vt`
// that no other face has.
class Model_obj_writer
{
public:
  Model_obj_writer(Output_file& file, const std::string& name, const Model& model,
                   const Model_texture& texture)
      : m_file(file), m_name(name), m_model(model), m_texture(texture), m_uv(model, texture)
  {}

  void write()
  {
    m_text = first_obj_line;
    end_line();
    for(std::size_t v = 0; v < m_model.points.size(); ++v) {
      write_point(v);
    }
    for(std::size_t i = 0; i < m_uv.size(); ++i) {
      write_line("vt", {m_uv[i].x(), m_uv[i].y()});
    }
    if(m_uv.size() > 0 && has_face_without_uv()) {
      m_text += "# of faces without texture coordinates:";
      end_line();
      write_line("vt", {0, 0});
      m_no_uv = static_cast<Index>(m_uv.size());
    }
    if(!m_model.corner_normals.empty() || m_model.has_point_normals) {
      for(const Kernel::Vector_3& normal : m_model.normals) {
        write_normal(normal);
      }
    }
    write_polygons();
    m_file.write(m_text);
  }

private:
  bool has_face_without_uv() const
  {
    for(Index p = 0; p < m_model.number_of_polygons(); ++p) {
      if(!has_uv_everywhere(m_model, m_texture, p)) {
        return true;
      }
    }
    return false;
  }

  void write_point(const std::size_t v)
  {
    const Kernel::Point_3& point = m_model.points[v];
    if(m_model.colors.empty() || !std::isfinite(m_model.colors[v][0])) {
      write_line("v", {point.x(), point.y(), point.z()});
    } else {
      const Point_color& color = m_model.colors[v];
      write_line("v", {point.x(), point.y(), point.z(), color[0], color[1], color[2]});
    }
  }

  // Those that could not be read have their number, but are not used.
  void write_normal(const Kernel::Vector_3& normal)
  {
    const bool is_known = std::isfinite(normal.x());
    write_line("vn", {is_known ? normal.x() : 0, is_known ? normal.y() : 0, is_known ? normal.z() : 0});
  }

  void write_line(const char* keyword, const std::initializer_list<double>& numbers)
  {
    m_text += keyword;
    for(const double number : numbers) {
      m_text += ' ';
      append_number(m_text, number);
    }
    end_line();
  }

  void write_polygons()
  {
    auto statement = m_model.statements.begin();
    for(std::size_t p = 0; p <= m_model.number_of_polygons(); ++p) {
      for(; statement != m_model.statements.end() && statement->polygon <= p; ++statement) {
        m_text += statement_elsewhere(*statement, m_model.name, m_name);
        end_line();
      }
      if(p < m_model.number_of_polygons()) {
        write_polygon(static_cast<Index>(p));
      }
    }
  }

  void write_polygon(const Index p)
  {
    const Index first = m_model.first_corners[p], end = m_model.first_corners[p + 1];
    const bool has_uv = has_uv_everywhere(m_model, m_texture, p);
    m_text += 'f';
    for(Index i = first; i < end; ++i) {
      const Index c = m_texture.is_turned[p] ? first + (end - 1 - i) : i;
      write_corner(c, has_uv ? m_uv.number(c) : m_no_uv);
    }
    end_line();
  }

  void write_corner(const Index c, const Index uv)
  {
    m_text += ' ';
    append_number(m_text, m_model.vertices[c] + 1);
    const Index normal = m_model.normal(c);
    if(uv != no_index || normal != no_index) {
      m_text += '/';
    }
    if(uv != no_index) {
      append_number(m_text, uv + 1);
    }
    if(normal != no_index) {
      m_text += '/';
      append_number(m_text, normal + 1);
    }
  }

  void end_line()
  {
    m_text += '\n';
    if(m_text.size() > 1000000) {
      m_file.write(m_text);
      m_text.clear();
    }
  }

  Output_file& m_file;
  const std::string& m_name;
  const Model& m_model;
  const Model_texture& m_texture;
  Shared_uv m_uv;
  Index m_no_uv = no_index; // the coordinates that stand for none
  std::string m_text;
};

} // namespace internal

// All that is kept of a model, with its texture, as an OBJ file of this name.
inline void write_model_obj(Output_file& file, const std::string& name, const Model& model,
                            const Model_texture& texture)
{
  internal::Model_obj_writer(file, name, model, texture).write();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_MODEL_OBJ_H
