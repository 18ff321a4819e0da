// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_PRIMITIVE_READER_H
#define FLATTEN_MESH_GLTF_PRIMITIVE_READER_H

#include "flatten_mesh/model/gltf/Gltf_accessors.h"
#include "flatten_mesh/model/gltf/Gltf_elements.h"
#include "flatten_mesh/model/gltf/Gltf_file.h"
#include "flatten_mesh/model/gltf/node_places.h"
#include "flatten_mesh/model/gltf/texture_transform.h"
#include "flatten_mesh/model/gltf_surface.h"
#include "flatten_mesh/texts.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

// The name of a mesh, or one that it gets
inline std::string mesh_name(const Gltf_file& file, const std::size_t mesh)
{
  const std::string& name = file.model.meshes[mesh].name;
  return name.empty() ? "mesh_" + std::to_string(mesh) : name;
}

// A primitive, for messages
inline std::string primitive_text(const Gltf_file& file, const std::size_t mesh, const std::size_t primitive)
{
  return "primitive " + std::to_string(primitive) + " of mesh '" + mesh_name(file, mesh) + "'";
}

namespace internal {

// In the place of a vertex: another strip or fan begins behind it, as KHR_mesh_primitive_restart says.
constexpr std::uint32_t restart = (std::numeric_limits<std::uint32_t>::max)();

// Triangles of the vertices of a primitive, in their order. Strips go elsewhere by triangles without extent.
inline std::vector<std::uint32_t> triangles_of(const std::vector<std::uint32_t>& vertices, const int mode)
{
  if(mode == TINYGLTF_MODE_TRIANGLES) {
    return vertices;
  }
  std::vector<std::uint32_t> triangles;
  std::size_t begin = 0; // of the strip or fan
  for(std::size_t i = 0; i < vertices.size(); ++i) {
    if(vertices[i] == restart) {
      begin = i + 1;
    }
    if(i < begin + 2) {
      continue;
    }
    const bool is_strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP, is_turned = is_strip && (i - begin) % 2 == 1;
    std::uint32_t a = vertices[is_strip ? i - 2 : begin], b = vertices[i - 1];
    const std::uint32_t c = vertices[i];
    if(a != b && b != c && c != a) {
      if(is_turned) {
        std::swap(a, b);
      }
      triangles.insert(triangles.end(), {a, b, c});
    }
  }
  return triangles;
}

} // namespace internal

// Reads primitives of triangles.
class Gltf_primitive_reader
{
public:
  Gltf_primitive_reader(const Gltf_file& file, const Gltf_options& options)
      : m_file(file), m_transforms_texture(options.transforms_texture), m_accessors(file)
  {}

  Gltf_primitive read(const std::size_t m, const std::size_t k, const Gltf_place& place) const
  {
    const tinygltf::Primitive& given = m_file.model.meshes[m].primitives[k];
    const std::string text = primitive_text(m_file, m, k);
    Gltf_primitive result;
    result.mesh = m;
    result.material = given.material < 0 ? -1 : given.material;
    if(result.material >= 0) {
      gltf_element(m_file, m_file.model.materials, given.material, text, "material");
    }
    if(given.attributes.count("POSITION") == 0) {
      refuse_gltf(m_file.name, text + " has no attribute POSITION");
    }
    const std::vector<double> positions = attribute(given, "POSITION", 3, text);
    const tinygltf::Accessor& accessor =
        m_file.model.accessors[static_cast<std::size_t>(given.attributes.at("POSITION"))];
    if(accessor.bufferView < 0 && !accessor.sparse.isSparse) {
      refuse_gltf(m_file.name, text + " has positions without a buffer view");
    }
    const std::size_t vertices = positions.size() / 3;
    result.triangles = internal::triangles_of(vertices_in_order(given, text, vertices), given.mode);
    result.numbers = take_used(vertices, result.triangles);
    result.positions = of_used(positions, 3, result.numbers);
    result.normals = of_used(attribute(given, "NORMAL", 3, text, vertices), 3, result.numbers);
    result.texture = of_used(attribute(given, "TEXCOORD_0", 2, text, vertices), 2, result.numbers);
    if(m_transforms_texture) {
      apply_texture_transform(m_file, result.material, result.texture);
    }
    result.colors = of_used(attribute(given, "COLOR_0", 4, text, vertices), 4, result.numbers);
    put(place, result);
    return result;
  }

  // As many as there are vertices
  Gltf_elements read_elements(const Gltf_accessor_name& name, const std::optional<std::size_t> vertices) const
  {
    Gltf_elements elements = m_accessors.read(name);
    if(vertices && elements.count != *vertices) {
      refuse_gltf(m_file.name, name.text() + " has " + count_text(elements.count, "element") +
                                   ", but there are " + count_text(*vertices, "vertex", "vertices"));
    }
    return elements;
  }

private:
  // Primitives may share their vertices: of each, only those that its triangles use are taken, and numbered again.
  static std::vector<std::uint32_t> take_used(const std::size_t vertices,
                                              std::vector<std::uint32_t>& triangles)
  {
    std::vector<std::uint32_t> new_numbers(vertices, 0), used;
    for(const std::uint32_t v : triangles) {
      new_numbers[v] = 1;
    }
    for(std::size_t v = 0; v < vertices; ++v) {
      if(new_numbers[v] == 1) {
        new_numbers[v] = static_cast<std::uint32_t>(used.size());
        used.push_back(static_cast<std::uint32_t>(v));
      }
    }
    for(std::uint32_t& v : triangles) {
      v = new_numbers[v];
    }
    return used;
  }

  static std::vector<double> of_used(const std::vector<double>& numbers, const std::size_t width,
                                     const std::vector<std::uint32_t>& used)
  {
    std::vector<double> result;
    result.reserve(numbers.empty() ? 0 : used.size() * width);
    for(const std::uint32_t v : used) {
      for(std::size_t i = 0; i < width && !numbers.empty(); ++i) {
        result.push_back(numbers[v * width + i]);
      }
    }
    return result;
  }

  // The numbers of a vertex attribute, or none. Colours may lack opacity.
  std::vector<double> attribute(const tinygltf::Primitive& given, const std::string& key,
                                const std::size_t width, const std::string& text,
                                const std::optional<std::size_t> vertices = std::nullopt) const
  {
    const auto place = given.attributes.find(key);
    if(place == given.attributes.end()) {
      return {};
    }
    const Gltf_accessor_name name = {place->second, key + " of " + text};
    const Gltf_elements elements = read_elements(name, vertices);
    if(elements.width() != width && !(width == 4 && elements.width() == 3)) {
      refuse_gltf(m_file.name, name.text() + " has " + count_text(elements.width(), "number") +
                                   " at each vertex instead of " + std::to_string(width));
    }
    std::vector<double> numbers = elements.numbers();
    if(elements.width() == width) {
      return numbers;
    }
    std::vector<double> widened;
    for(std::size_t i = 0; i < numbers.size(); i += 3) {
      widened.insert(widened.end(), {numbers[i], numbers[i + 1], numbers[i + 2], 1});
    }
    return widened;
  }

  // In the order in which they make triangles
  std::vector<std::uint32_t> vertices_in_order(const tinygltf::Primitive& given, const std::string& text,
                                               const std::size_t number_of_vertices) const
  {
    std::vector<std::uint32_t> vertices;
    if(given.indices < 0) {
      for(std::size_t v = 0; v < number_of_vertices; ++v) {
        vertices.push_back(static_cast<std::uint32_t>(v));
      }
    } else {
      const Gltf_accessor_name name = {given.indices, "indices of " + text};
      const Gltf_elements elements = m_accessors.read(name);
      const bool is_unsigned = elements.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                               elements.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                               elements.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
      if(!is_unsigned || elements.width() != 1) {
        refuse_gltf(m_file.name, name.text() + " does not contain indices");
      }
      const double largest = elements.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 255
                             : elements.component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 65535
                                                                                                 : 4294967295;
      vertices.resize(elements.count);
      for(std::size_t i = 0; i < elements.count; ++i) {
        const double index = elements.raw_number(i);
        if(index == largest && given.mode != TINYGLTF_MODE_TRIANGLES) {
          vertices[i] = internal::restart;
          continue;
        }
        if(!(index < static_cast<double>(number_of_vertices))) {
          refuse_gltf(m_file.name, name.text() + " names vertex " + format_number("%.10g", index) +
                                       " (counted from 0), which does not exist: there are only " +
                                       std::to_string(number_of_vertices));
        }
        vertices[i] = static_cast<std::uint32_t>(index);
      }
    }
    if(given.mode == TINYGLTF_MODE_TRIANGLES && vertices.size() % 3 != 0) {
      refuse_gltf(m_file.name, text + " has " + count_text(vertices.size(), "corner") +
                                   ", which are no triples for triangles");
    }
    return vertices;
  }

  static void put(const Gltf_place& place, Gltf_primitive& primitive)
  {
    for(std::size_t i = 0; i < primitive.positions.size(); i += 3) {
      double* const p = &primitive.positions[i];
      const std::array<double, 3> point = place.point({p[0], p[1], p[2]});
      std::copy(point.begin(), point.end(), p);
    }
    for(std::size_t i = 0; i < primitive.normals.size(); i += 3) {
      double* const n = &primitive.normals[i];
      const std::array<double, 3> normal = place.normal({n[0], n[1], n[2]});
      std::copy(normal.begin(), normal.end(), n);
    }
    primitive.is_mirrored = place.determinant() < 0;
    for(std::size_t i = 0; i < primitive.triangles.size() && primitive.is_mirrored; i += 3) {
      std::swap(primitive.triangles[i + 1], primitive.triangles[i + 2]);
    }
  }

  const Gltf_file& m_file;
  bool m_transforms_texture;
  Gltf_accessors m_accessors;
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_PRIMITIVE_READER_H
