// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_MODEL_OBJ_H
#define FLATTEN_MESH_WRITE_MODEL_OBJ_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/model/material_files.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

// The different texture coordinates of a model. Corners at the same point in the same chart share theirs if they are
// equal.
class Shared_uv
{
public:
  Shared_uv(const Model& model, const Model_texture& texture)
      : m_numbers(model.number_of_corners(), no_index), m_first(model.points.size(), no_index)
  {
    for(std::size_t p = 0; p < model.number_of_polygons(); ++p) {
      const auto polygon = static_cast<Index>(p);
      for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c) {
        if(texture.has_uv(c)) {
          m_numbers[c] =
              number_of({texture.uv[c], texture.chart(polygon), no_index}, m_first[model.vertices[c]]);
        }
      }
    }
  }

  std::size_t size() const { return m_places.size(); }
  const Kernel::Point_2& operator[](const std::size_t number) const { return m_places[number].uv; }

  // Of a corner, from 0, or `no_index`
  Index number(const Index corner) const { return m_numbers[corner]; }

private:
  struct Place
  {
    Kernel::Point_2 uv;
    Index chart;
    Index next; // of the same point
  };

  Index number_of(Place place, Index& first)
  {
    for(Index i = first; i != no_index; i = m_places[i].next) {
      if(m_places[i].chart == place.chart && m_places[i].uv == place.uv) {
        return i;
      }
    }
    place.next = first;
    first = static_cast<Index>(m_places.size());
    m_places.push_back(place);
    return first;
  }

  std::vector<Index> m_numbers; // of each corner
  std::vector<Index> m_first;   // of each point: its last place so far
  std::vector<Place> m_places;
};

// Writes the lines of an OBJ file, a part of the text at a time.
class Model_obj_writer
{
public:
  Model_obj_writer(Output_file& file, const std::string& name, const Model& model,
                   const Model_texture& texture)
      : m_file(file), m_name(name), m_model(model), m_texture(texture), m_uv(model, texture)
  {}

  void write()
  {
    m_text = "# texture coordinates 'vt' by flatten_mesh\n";
    for(std::size_t v = 0; v < m_model.points.size(); ++v) {
      write_point(v);
    }
    for(std::size_t i = 0; i < m_uv.size(); ++i) {
      write_line("vt", {m_uv[i].x(), m_uv[i].y()});
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
    m_text += 'f';
    for(Index i = first; i < end; ++i) {
      write_corner(m_texture.is_turned[p] ? first + (end - 1 - i) : i);
    }
    end_line();
  }

  void write_corner(const Index c)
  {
    m_text += ' ';
    append_number(m_text, m_model.vertices[c] + 1);
    const Index uv = m_uv.number(c), normal = m_model.normal(c);
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
