// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_READ_GLTF_H
#define FLATTEN_MESH_READ_GLTF_H

#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Gltf_options.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/color_spaces.h"
#include "flatten_mesh/model/gltf_surface.h"
#include "flatten_mesh/model/join_vertices.h"
#include "flatten_mesh/texts.h"

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Makes a model of the triangles of a glTF file, one primitive after the other.
class Gltf_model
{
public:
  Gltf_model(const Gltf_surface& surface, Model& model) : m_surface(surface), m_model(model)
  {
    m_model.gltf.file = surface.file;
    m_model.files_beside = surface.files_beside;
    std::unordered_set<std::string> names;
    for(const Glb_material& material : surface.materials) {
      m_model.material_names.push_back(new_name(material.name, names));
      m_model.material_colors.push_back(material.color);
    }
  }

  // Joins vertices mesh by mesh: meshes that touch are different things.
  void add_all(const bool joins_vertices)
  {
    const auto& primitives = m_surface.primitives;
    for(std::size_t i = 0; i < primitives.size(); ++i) {
      if(i == 0 || primitives[i].mesh != primitives[i - 1].mesh) {
        m_first_polygon = m_model.number_of_polygons();
        m_first_point = m_model.points.size();
        add_statement("o " + in_one_line(m_surface.mesh_names[primitives[i].mesh]));
      }
      add(static_cast<Index>(i), primitives[i]);
      if(joins_vertices && (i + 1 == primitives.size() || primitives[i + 1].mesh != primitives[i].mesh)) {
        join_vertices(m_first_polygon, m_first_point, m_model);
      }
    }
    if(m_model.materials.empty()) {
      m_model.material_names.clear();
      m_model.material_colors.clear();
    }
  }

private:
  // As OBJ files can have it, and different from the others
  std::string new_name(const std::string& given, std::unordered_set<std::string>& names) const
  {
    const std::string number = std::to_string(m_model.material_names.size());
    std::string name = boost::algorithm::trim_copy(in_one_line(given));
    name = name.empty() ? "material_" + number : name;
    while(!names.insert(name).second) {
      name += "_" + number;
    }
    return name;
  }

  void add_statement(const std::string& text)
  {
    m_model.statements.push_back({static_cast<Index>(m_model.number_of_polygons()), text});
  }

  void add(const Index number, const Gltf_primitive& primitive)
  {
    const auto first = static_cast<Index>(m_model.points.size()),
               first_normal = static_cast<Index>(m_model.normals.size()),
               first_texture = static_cast<Index>(m_model.texture.size());
    if(primitive.number_of_vertices() >= no_index - first) {
      throw Input_error("'" + m_model.name + "': the file has more than 4294967294 vertices; split the mesh");
    }
    const auto material = static_cast<Index>(primitive.material); // -1 is `no_index`
    if(material != m_material) {
      add_statement("usemtl " + (material == no_index ? "default" : m_model.material_names[material]));
      m_material = material;
    }
    add_vertices(primitive);
    m_model.gltf.is_mirrored.push_back(primitive.is_mirrored);
    const std::size_t first_corner = m_model.number_of_corners(),
                      first_polygon = m_model.number_of_polygons();
    for(std::size_t i = 0; i < primitive.triangles.size(); ++i) {
      const std::uint32_t v = primitive.triangles[i];
      m_model.vertices.push_back(first + v);
      m_model.gltf.vertices.push_back(primitive.numbers[v]);
      if(i % 3 == 2) {
        m_model.end_polygon();
        m_model.gltf.primitives.push_back(number);
      }
    }
    add_attributes(!primitive.normals.empty(), first_normal - first, first_corner, m_model.corner_normals);
    add_attributes(!primitive.texture.empty(), first_texture - first, first_corner, m_model.corner_texture);
    if(material != no_index || !m_model.materials.empty()) {
      m_model.materials.resize(first_polygon, no_index);
      m_model.materials.resize(m_model.number_of_polygons(), material);
    }
  }

  void add_vertices(const Gltf_primitive& primitive)
  {
    for(std::size_t v = 0; v < primitive.number_of_vertices(); ++v) {
      const double* const p = &primitive.positions[3 * v];
      m_model.points.emplace_back(p[0], p[1], p[2]);
      if(!primitive.normals.empty()) {
        const double* const n = &primitive.normals[3 * v];
        m_model.normals.emplace_back(n[0], n[1], n[2]);
      }
      if(!primitive.texture.empty()) { // there, v goes down
        m_model.texture.emplace_back(primitive.texture[2 * v], 1 - primitive.texture[2 * v + 1]);
      }
    }
    if(!primitive.colors.empty() || !m_model.colors.empty()) {
      const double none = std::numeric_limits<double>::quiet_NaN();
      m_model.colors.resize(m_model.points.size() - primitive.number_of_vertices(), {none, none, none, none});
      for(std::size_t v = 0; v < primitive.number_of_vertices(); ++v) {
        const double* const c = primitive.colors.empty() ? nullptr : &primitive.colors[4 * v];
        m_model.colors.push_back(c == nullptr ? Point_color{none, none, none, none}
                                              : srgb_of_linear({c[0], c[1], c[2], c[3]}));
      }
    }
  }

  // Of the corners from the first on, which are those of the vertices, or missing
  void add_attributes(const bool are_there, const Index offset, const std::size_t first_corner,
                      std::vector<Index>& corners) const
  {
    if(!are_there && corners.empty()) {
      return;
    }
    corners.resize(first_corner, no_index);
    for(std::size_t c = first_corner; c < m_model.number_of_corners(); ++c) {
      corners.push_back(are_there ? m_model.vertices[c] + offset : no_index);
    }
  }

  const Gltf_surface& m_surface;
  Model& m_model;
  std::size_t m_first_polygon = 0, m_first_point = 0; // of the mesh
  Index m_material = no_index;
};

inline void tell_gltf(const Gltf_surface& surface, const Gltf_options& options, const std::string& file,
                      Notes& notes)
{
  const std::string begin = "'" + file + "': ";
  for(const std::string& remark : surface.remarks) {
    notes.add(begin + remark);
  }
  if(surface.instances > 0) {
    notes.add(begin + count_text(surface.instances, "node") + " " +
              (surface.instances == 1 ? "shows a mesh" : "show meshes") +
              " that another node shows as well: each mesh is flattened once, " +
              (options.keeps_scene ? "for all of its nodes" : "where its first node shows it") +
              "; '--unique-instances' flattens it for each node");
  }
  if(!options.keeps_scene && !surface.scene_parts.empty()) {
    notes.add(begin + "the output is the surface without what else is in the file: " + surface.scene_parts +
              "; '--output FILE.glb' keeps it");
  }
}

} // namespace internal

// Reads a binary or textual glTF file. Throws an `Input_error` that names what is wrong.
inline void read_gltf(const std::string_view content, Model& model, const Gltf_options& options, Notes& notes)
{
  const bool is_binary = boost::algorithm::starts_with(content, "glTF");
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  if(!is_binary && (first == content.npos || content[first] != '{')) {
    throw Input_error(
        "'" + model.name +
        "': glTF files begin with 'glTF' if they are binary, and otherwise with '{'; export the "
        "mesh again");
  }
  const Gltf_surface surface = gltf_surface(content, is_binary, model.name, options);
  internal::Gltf_model(surface, model).add_all(options.joins_vertices);
  internal::tell_gltf(surface, options, model.name, notes);
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_READ_GLTF_H
