// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_MODEL_PLY_H
#define FLATTEN_MESH_WRITE_MODEL_PLY_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/model/Model_style.h"
#include "flatten_mesh/model/Shared_uv.h"
#include "flatten_mesh/model/own_marks.h"

#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

// The normal of each point, or empty if points have different normals at different corners, or none at some.
inline std::vector<Kernel::Vector_3> normals_of_points(const Model& model)
{
  if(model.has_point_normals) {
    return model.normals;
  }
  if(model.corner_normals.empty()) {
    return {};
  }
  std::vector<Kernel::Vector_3> normals(model.points.size(), Kernel::Vector_3(0, 0, 0));
  std::vector<bool> is_known(model.points.size(), false);
  for(Index c = 0; c < model.number_of_corners(); ++c) {
    const Index v = model.vertices[c], normal = model.normal(c);
    if(normal == no_index || (is_known[v] && normals[v] != model.normals[normal])) {
      return {};
    }
    normals[v] = model.normals[normal];
    is_known[v] = true;
  }
  return normals;
}

// The points of a file whose vertices have texture coordinates: those of the model, in their order, and after them the
// further places of points on seams. Faces without coordinates have vertices of their own, with zeros.
class Split_points
{
public:
  Split_points(const Model& model, const Model_texture& texture)
      : uv(model.points.size(), {0, 0}), vertices(model.number_of_corners())
  {
    for(Index v = 0; v < model.points.size(); ++v) {
      points.push_back(v);
    }
    const Shared_uv shared(model, texture);
    std::vector<Index> of_uv(shared.size(), no_index), without_uv(model.points.size(), no_index);
    std::vector<bool> is_taken(model.points.size(), false);
    for(Index p = 0; p < model.number_of_polygons(); ++p) {
      const bool has_uv = has_uv_everywhere(model, texture, p);
      for(Index c = model.first_corners[p]; c < model.first_corners[p + 1]; ++c) {
        const Index v = model.vertices[c];
        Index& vertex = has_uv ? of_uv[shared.number(c)] : without_uv[v];
        if(vertex == no_index) {
          vertex = is_taken[v] ? static_cast<Index>(points.size()) : v;
          if(is_taken[v]) {
            points.push_back(v);
            uv.emplace_back(0, 0);
          }
          is_taken[v] = true;
          uv[vertex] = has_uv ? shared[shared.number(c)] : uv[vertex];
        }
        vertices[c] = vertex;
      }
    }
  }

  std::vector<Index> points;       // of each vertex
  std::vector<Kernel::Point_2> uv; // of each vertex
  std::vector<Index> vertices;     // of each corner
};

// A binary PLY file, a part at a time. A face without coordinates has a list of zeros as long as that of others: of an
// empty list, some programs shift all that follow, and others refuse the file. CGAL has no writer for texture coordinates of corners.
class Model_ply_writer
{
public:
  Model_ply_writer(Output_file& file, const Model& model, const Model_texture& texture,
                   const Model_style& style)
      : m_file(file), m_model(model), m_texture(texture), m_style(style), m_normals(normals_of_points(model))
  {
    if(style.has_uv_at_vertices) {
      m_split.emplace(model, texture);
    }
    for(const Kernel::Point_3& point : model.points) {
      m_is_double = m_is_double || !is_float(point.x()) || !is_float(point.y()) || !is_float(point.z());
    }
    for(const Point_color& color : model.colors) {
      m_has_opacity = m_has_opacity || color[3] != 1;
    }
    for(Index p = 0; p < model.number_of_polygons(); ++p) {
      m_is_large = m_is_large || 2 * model.size(p) > 255;
    }
  }

  void write()
  {
    write_header();
    for(std::size_t v = 0; v < number_of_points(); ++v) {
      write_point(m_split ? m_split->points[v] : v);
      if(m_split) {
        write_uv_of_vertex(m_split->uv[v]);
      }
      pass_on();
    }
    for(Index p = 0; p < m_model.number_of_polygons(); ++p) {
      write_polygon(p);
      pass_on();
    }
    m_file.write(m_text);
  }

private:
  static bool is_float(const double number)
  {
    return static_cast<double>(static_cast<float>(number)) == number;
  }

  void write_header()
  {
    const std::string real = m_is_double ? "double" : "float", count = m_is_large ? "uint" : "uchar";
    const std::string list = m_texture.is_second_set ? "texcoord1" : "texcoord";
    m_text = "ply\nformat binary_little_endian 1.0\ncomment texture coordinates " +
             (m_split ? std::string("of vertices") : "'" + list + "'") + " " + end_of_ply_comment + "\n";
    if(!m_style.texture.empty()) {
      m_text += "comment TextureFile " + m_style.texture + "\n";
    }
    m_text += "element vertex " + std::to_string(number_of_points()) + "\n";
    add_properties(real, {"x", "y", "z"});
    if(!m_normals.empty()) {
      add_properties(real, {"nx", "ny", "nz"});
    }
    if(!m_model.colors.empty()) {
      add_properties("uchar", {"red", "green", "blue"});
      if(m_has_opacity) {
        add_properties("uchar", {"alpha"});
      }
    }
    if(m_split) {
      add_properties("float", {"s", "t", "u", "v", "texture_u", "texture_v"});
    }
    m_text += "element face " + std::to_string(m_model.number_of_polygons()) + "\nproperty list " + count +
              " int vertex_indices\n";
    if(!m_split) {
      m_text += "property list " + count + " float texcoord\n";
    }
    if(m_texture.is_second_set) {
      m_text += "property list " + count + " float texcoord1\n";
    }
    if(has_charts()) {
      add_properties("int", {"chart"});
    }
    m_text += "end_header\n";
  }

  void add_properties(const std::string& type, const std::vector<std::string>& names)
  {
    for(const std::string& name : names) {
      m_text += "property " + type + " " + name + "\n";
    }
  }

  void write_point(const std::size_t v)
  {
    const Kernel::Point_3& point = m_model.points[v];
    add_reals({point.x(), point.y(), point.z()});
    if(!m_normals.empty()) {
      add_reals({m_normals[v].x(), m_normals[v].y(), m_normals[v].z()});
    }
    if(!m_model.colors.empty()) {
      const bool is_known = std::isfinite(m_model.colors[v][0]);
      for(std::size_t i = 0; i < (m_has_opacity ? 4 : 3); ++i) {
        const double part = is_known ? m_model.colors[v][i] : 1;
        add(static_cast<std::uint8_t>(std::lround(255 * (std::min)((std::max)(part, 0.), 1.))));
      }
    }
  }

  // Programs that read no list of coordinates may read no other property of faces, either.
  bool has_charts() const { return !m_split && !m_texture.charts.empty(); }

  // Under each name that some program reads
  void write_uv_of_vertex(const Kernel::Point_2& uv)
  {
    for(int i = 0; i < 3; ++i) {
      add(static_cast<float>(uv.x()));
      add(static_cast<float>(uv.y()));
    }
  }

  std::size_t number_of_points() const { return m_split ? m_split->points.size() : m_model.points.size(); }

  void write_polygon(const Index p)
  {
    const Index first = m_model.first_corners[p], size = m_model.size(p);
    const auto corner = [&](const Index i) { return first + (m_texture.is_turned[p] ? size - 1 - i : i); };
    add_count(size);
    for(Index i = 0; i < size; ++i) {
      const Index c = corner(i);
      add(static_cast<std::int32_t>(m_split ? m_split->vertices[c] : m_model.vertices[c]));
    }
    if(m_texture.is_second_set) {
      add_uv(size, [&](const Index i) { return own_uv(corner(i)); });
    }
    if(!m_split) {
      add_uv(size, [&](const Index i) { return m_texture.uv[corner(i)]; });
    }
    if(has_charts()) {
      add(static_cast<std::int32_t>(m_texture.charts[p])); // -1: none
    }
  }

  // NaN where there is none
  Kernel::Point_2 own_uv(const Index c) const
  {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const Index point = m_model.texture_point(c);
    return point == no_index ? Kernel::Point_2(none, none) : m_model.texture[point];
  }

  // The coordinates of all corners, or zeros
  template <class Uv>
  void add_uv(const Index size, const Uv& uv)
  {
    bool has_uv = true;
    for(Index i = 0; i < size; ++i) {
      has_uv = has_uv && std::isfinite(uv(i).x());
    }
    add_count(2 * size);
    for(Index i = 0; i < size; ++i) {
      add(has_uv ? static_cast<float>(uv(i).x()) : 0.f);
      add(has_uv ? static_cast<float>(uv(i).y()) : 0.f);
    }
  }

  void add_reals(const std::initializer_list<double>& numbers)
  {
    for(const double number : numbers) {
      if(m_is_double) {
        add(number);
      } else {
        add(static_cast<float>(number));
      }
    }
  }

  void add_count(const Index count)
  {
    if(m_is_large) {
      add(count);
    } else {
      add(static_cast<std::uint8_t>(count));
    }
  }

  template <class Number>
  void add(const Number number)
  {
    char bytes[sizeof(Number)];
    std::memcpy(bytes, &number, sizeof(Number));
    if(boost::endian::order::native == boost::endian::order::big) {
      std::reverse(bytes, bytes + sizeof(Number));
    }
    m_text.append(bytes, sizeof(Number));
  }

  void pass_on()
  {
    if(m_text.size() > 1000000) {
      m_file.write(m_text);
      m_text.clear();
    }
  }

  Output_file& m_file;
  const Model& m_model;
  const Model_texture& m_texture;
  const Model_style& m_style;
  std::optional<Split_points> m_split;     // if vertices have the coordinates
  std::vector<Kernel::Vector_3> m_normals; // of each point, or empty
  bool m_is_double = false;                // coordinates do not fit into `float`
  bool m_has_opacity = false;
  bool m_is_large = false; // numbers of corners do not fit into a byte
  std::string m_text;
};

} // namespace internal

// Points with their normals and colours, polygons, and the texture coordinates of their corners as a list `texcoord`. A
// second set is a list `texcoord1`.
inline void write_model_ply(Output_file& file, const Model& model, const Model_texture& texture,
                            const Model_style& style)
{
  internal::Model_ply_writer(file, model, texture, style).write();
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_MODEL_PLY_H
