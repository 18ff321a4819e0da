// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLB_TEXT_H
#define FLATTEN_MESH_GLB_TEXT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flatten_mesh {

struct Glb_material
{
  std::string name;
  std::array<double, 4> color; // red, green, blue, opacity
  bool has_pictures = false;
};

// PNG files, or empty
struct Glb_pictures
{
  std::string normals, colors;
  bool has_tiny_one = false; // which shows nothing, and refers to all texture coordinates
};

// Triangles of one material. The numbers of a vertex follow one another.
struct Glb_primitive
{
  std::size_t material = 0;
  std::vector<float> positions;      // 3
  std::vector<float> normals;        // 3, or empty
  std::vector<float> tangents;       // 4, or empty
  std::vector<float> texture;        // 2, or empty
  std::vector<float> second_texture; // 2, or empty; only after the first one
  std::vector<float> colors;         // 4, or empty
  std::vector<std::uint32_t> indices;

  std::size_t bytes() const
  {
    return sizeof(float) * (positions.size() + normals.size() + tangents.size() + texture.size() +
                            second_texture.size() + colors.size() + indices.size());
  }
};

// The format counts bytes with 32 bits. Some are left for the description.
constexpr std::size_t largest_glb = 4200000000;

// A binary glTF file of one mesh, of at most `largest_glb` bytes of numbers. Its origin is at `place`.
std::string glb_text(const std::vector<Glb_material>& materials, const std::vector<Glb_primitive>& primitives,
                     const Glb_pictures& pictures = {}, const std::array<double, 3>& place = {0, 0, 0});

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLB_TEXT_H
