// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_MODEL_GLB_H
#define FLATTEN_MESH_WRITE_MODEL_GLB_H

#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/model/Model_style.h"
#include "flatten_mesh/model/color_spaces.h"
#include "flatten_mesh/model/glb_text.h"
#include "flatten_mesh/model/material_files.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

// The triangles of a model whose corners have the same attributes, as glTF wants them: corners of the same point are
// one vertex only if all is equal.
class Glb_part
{
public:
  Glb_part(const Model& model, const Model_texture& texture, const std::array<double, 3>& origin,
           const bool has_uv, const bool has_normals)
      : m_model(model), m_texture(texture), m_origin(origin), m_has_uv(has_uv), m_has_normals(has_normals),
        m_has_first(texture.is_second_set && (has_uv || !model.texture.empty()))
  {}

  void add_corner(const Index c) { m_primitive.indices.push_back(vertex_of(c)); }

  Glb_primitive&& result() { return std::move(m_primitive); }

private:
  bool has_tangents() const { return m_has_uv && m_has_normals && !m_texture.tangents.empty(); }

  bool is_same(const Index c, const Index d) const
  {
    return (!m_has_uv || m_texture.uv[c] == m_texture.uv[d]) &&
           (!m_has_first || first_of_two_uv(m_model, c) == first_of_two_uv(m_model, d)) &&
           (!m_has_normals || m_model.normals[m_model.normal(c)] == m_model.normals[m_model.normal(d)]) &&
           (!has_tangents() || m_texture.tangents[c] == m_texture.tangents[d]);
  }

  std::uint32_t vertex_of(const Index c)
  {
    const auto number = static_cast<std::uint32_t>(m_corners.size());
    const auto [place, is_new] = m_last.emplace(m_model.vertices[c], number);
    for(std::uint32_t i = is_new ? no_index : place->second; i != no_index; i = m_before[i]) {
      if(is_same(m_corners[i], c)) {
        return i;
      }
    }
    m_before.push_back(is_new ? no_index : place->second);
    place->second = number;
    m_corners.push_back(c);
    add_numbers(c);
    return number;
  }

  void add_numbers(const Index c)
  {
    const auto add = [](std::vector<float>& numbers, const double number) {
      numbers.push_back(static_cast<float>(number));
    };
    const Index v = m_model.vertices[c];
    for(int axis = 0; axis < 3; ++axis) {
      add(m_primitive.positions, m_model.points[v][axis] - m_origin[static_cast<std::size_t>(axis)]);
    }
    const auto add_uv = [&add](std::vector<float>& numbers, const Kernel::Point_2& uv) {
      add(numbers, uv.x());
      add(numbers, 1 - uv.y()); // there, v goes down
    };
    if(m_has_first) {
      add_uv(m_primitive.texture, first_of_two_uv(m_model, c));
    }
    if(m_has_uv) {
      add_uv(m_has_first ? m_primitive.second_texture : m_primitive.texture, m_texture.uv[c]);
    }
    if(m_has_normals) {
      const Kernel::Vector_3& normal = m_model.normals[m_model.normal(c)];
      for(int axis = 0; axis < 3; ++axis) {
        add(m_primitive.normals, normal[axis] / std::sqrt(normal.squared_length()));
      }
    }
    if(has_tangents()) {
      for(const double part : m_texture.tangents[c]) {
        add(m_primitive.tangents, part);
      }
    }
    if(!m_model.colors.empty()) {
      const Point_color& color = m_model.colors[v];
      for(const double part : std::isfinite(color[0]) ? linear_of_srgb(color) : Point_color{1, 1, 1, 1}) {
        add(m_primitive.colors, part);
      }
    }
  }

  const Model& m_model;
  const Model_texture& m_texture;
  std::array<double, 3> m_origin;
  bool m_has_uv;
  bool m_has_normals;
  bool m_has_first; // of two sets
  Glb_primitive m_primitive;
  std::vector<Index> m_corners;                    // of each vertex: one of its corners
  std::vector<std::uint32_t> m_before;             // of each vertex: the vertex before it of the same point
  std::unordered_map<Index, std::uint32_t> m_last; // of each point: its last vertex
};

inline bool has_direction(const Model& model, const Index corner)
{
  const Index normal = model.normal(corner);
  const double length = normal == no_index ? 0 : model.normals[normal].squared_length();
  return std::isfinite(length) && length > (std::numeric_limits<double>::min)();
}

// The number of a material with or without pictures. Those with pictures are asked for first.
inline std::size_t pictured_material(std::vector<Glb_material>& materials, const std::size_t number,
                                     const bool has_pictures)
{
  if(has_pictures || !materials[number].has_pictures) {
    materials[number].has_pictures = has_pictures;
    return number;
  }
  materials.push_back(materials[number]);
  materials.back().has_pictures = false;
  return materials.size() - 1;
}

} // namespace internal

// Where the origin of a model has to be so that `float` tells its points apart: in the middle, if it is farther away
// than a hundred times the extent, as that of a terrain in geographic coordinates is. Otherwise it stays.
inline std::array<double, 3> origin_of_floats(const Model& model)
{
  const double most = (std::numeric_limits<double>::max)();
  std::array<double, 3> low = {most, most, most}, high = {-most, -most, -most};
  for(const Index v : model.vertices) {
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const double x = model.points[v][static_cast<int>(axis)];
      low[axis] = std::isfinite(x) ? (std::min)(low[axis], x) : low[axis];
      high[axis] = std::isfinite(x) ? (std::max)(high[axis], x) : high[axis];
    }
  }
  double extent = 0, farthest = 0;
  std::array<double, 3> middle = {0, 0, 0};
  for(std::size_t axis = 0; axis < 3; ++axis) {
    extent = (std::max)(extent, high[axis] - low[axis]);
    farthest = (std::max)({farthest, std::abs(low[axis]), std::abs(high[axis])});
    middle[axis] = low[axis] / 2 + high[axis] / 2;
  }
  return farthest > 100 * extent && extent > 0 ? middle : std::array<double, 3>{0, 0, 0};
}

// The triangles of a model as a binary glTF file. Each material has at most four primitives: of polygons with and
// without texture coordinates, with and without normals. Throws an `Output_error` if the file would be too large for
// the format.
inline void write_model_glb(Output_file& file, const std::string& name, const Model& model,
                            const Model_texture& texture, const Model_style& style)
{
  std::vector<Glb_material> materials;
  const std::vector<Point_color> colors = material_colors(model);
  for(std::size_t i = 0; i < colors.size(); ++i) {
    materials.push_back({model.material_names[i], colors[i]});
  }
  const bool has_pictures = texture.has_pictures() || style.has_tiny_picture;
  if(!texture.color_picture.empty()) { // which would be multiplied by them
    for(Glb_material& material : materials) {
      material.color = {1, 1, 1, material.color[3]};
    }
  }
  const std::array<double, 3> origin = origin_of_floats(model);
  const std::size_t without_name = materials.size();
  std::map<std::tuple<std::size_t, bool, bool>, internal::Glb_part> parts;
  for(const Model_triangle& triangle : texture.triangles) {
    const Index given = model.material(triangle.polygon);
    const std::size_t material = given == no_index ? without_name : given;
    bool has_uv = true, has_normals = true;
    for(const Index c : triangle.corners) {
      has_uv = has_uv && texture.has_uv(c);
      has_normals = has_normals && internal::has_direction(model, c);
    }
    internal::Glb_part& part =
        parts.try_emplace({material, !has_uv, !has_normals}, model, texture, origin, has_uv, has_normals)
            .first->second;
    for(const Index c : triangle.corners) {
      part.add_corner(c);
    }
  }
  std::vector<Glb_primitive> primitives;
  std::size_t bytes = texture.normal_picture.size() + texture.color_picture.size();
  for(auto& [key, part] : parts) {
    const auto& [material, has_no_uv, has_no_normals] = key;
    if(material == without_name && materials.size() == without_name) {
      materials.push_back({"default", {1, 1, 1, 1}});
    }
    primitives.push_back(part.result());
    primitives.back().material = internal::pictured_material(materials, material, has_pictures && !has_no_uv);
    bytes += primitives.back().bytes();
  }
  if(bytes > largest_glb) {
    throw Output_error("cannot write '" + name + "': binary glTF files have at most 4 GB; use .ply or .obj");
  }
  file.write(glb_text(materials, primitives,
                      {texture.normal_picture, texture.color_picture, style.has_tiny_picture}, origin));
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_MODEL_GLB_H
