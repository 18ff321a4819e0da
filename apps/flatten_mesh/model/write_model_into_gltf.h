// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WRITE_MODEL_INTO_GLTF_H
#define FLATTEN_MESH_WRITE_MODEL_INTO_GLTF_H

#include "flatten_mesh/Output_file.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Model_style.h"
#include "flatten_mesh/model/gltf_surface.h"

#include <CGAL/Texture_atlas/internal/prepare/Model_texture.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

namespace internal {

// Triangles of one primitive of a glTF file. A vertex is there once for each of its places in the texture.
class Gltf_part
{
public:
  Gltf_part(const std::size_t primitive, const bool has_uv) : m_has_uv(has_uv)
  {
    m_triangles.primitive = primitive;
  }

  void add_corner(const Index vertex, const Kernel::Point_2& uv)
  {
    const auto number = static_cast<std::uint32_t>(m_triangles.vertices.size());
    const std::array<float, 2> texture = {static_cast<float>(uv.x()), static_cast<float>(1 - uv.y())};
    const auto [place, is_new] = m_last.emplace(vertex, number);
    for(std::uint32_t i = is_new ? no_index : place->second; i != no_index; i = m_before[i]) {
      if(!m_has_uv ||
         std::array<float, 2>{m_triangles.texture[2 * i], m_triangles.texture[2 * i + 1]} == texture) {
        m_triangles.triangles.push_back(i);
        return;
      }
    }
    m_before.push_back(is_new ? no_index : place->second);
    place->second = number;
    m_triangles.vertices.push_back(vertex);
    m_triangles.triangles.push_back(number);
    if(m_has_uv) {
      m_triangles.texture.insert(m_triangles.texture.end(), texture.begin(), texture.end());
    }
  }

  Gltf_triangles&& result() { return std::move(m_triangles); }

private:
  bool m_has_uv;
  Gltf_triangles m_triangles;
  std::vector<std::uint32_t> m_before;             // of each new vertex: the one before it of the same vertex
  std::unordered_map<Index, std::uint32_t> m_last; // of each vertex: its last new one
};

} // namespace internal

// A model from a glTF file as binary glTF, with all that the file contains. Of each primitive, triangles without
// texture coordinates become one of their own. Throws an `Output_error` if the file would be too large for the format.
inline void write_model_into_gltf(Output_file& file, const std::string& name, const Model& model,
                                  const Model_texture& texture, const Model_style& style)
{
  std::map<std::pair<Index, bool>, internal::Gltf_part> parts;
  for(const Model_triangle& triangle : texture.triangles) {
    const Index primitive = model.gltf.primitives[triangle.polygon];
    std::array<Index, 3> corners = triangle.corners;
    bool has_uv = true;
    for(const Index c : corners) {
      has_uv = has_uv && texture.has_uv(c);
    }
    if(model.gltf.is_mirrored[primitive]) { // by nodes, which mirror it again
      std::swap(corners[1], corners[2]);
    }
    internal::Gltf_part& part = parts.try_emplace({primitive, !has_uv}, primitive, has_uv).first->second;
    for(const Index c : corners) {
      part.add_corner(model.gltf.vertices[c], texture.uv[c]);
    }
  }
  std::vector<Gltf_triangles> triangles;
  for(auto& [key, part] : parts) {
    triangles.push_back(part.result());
  }
  file.write(
      gltf_with_texture(*model.gltf.file, triangles, {texture.is_second_set, style.has_tiny_picture}, name));
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WRITE_MODEL_INTO_GLTF_H
