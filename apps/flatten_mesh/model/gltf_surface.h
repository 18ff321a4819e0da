// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_SURFACE_H
#define FLATTEN_MESH_GLTF_SURFACE_H

#include "flatten_mesh/model/Gltf_options.h"
#include "flatten_mesh/model/glb_text.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace flatten_mesh {

// All that a glTF file contains: see `gltf/Gltf_file.h`.
struct Gltf_file;

// Triangles of a glTF file, where their node puts them. The numbers of a vertex follow one another.
struct Gltf_primitive
{
  std::size_t mesh = 0;          // in `Gltf_surface::mesh_names`
  int material = -1;             // in `Gltf_surface::materials`; -1: none
  bool is_mirrored = false;      // by its node: triangles are turned, so that their front stays in front
  std::vector<double> positions; // 3
  std::vector<double> normals;   // 3, or empty
  std::vector<double> texture;   // 2, or empty; v goes down
  std::vector<double> colors;    // 4, or empty
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> numbers; // of each vertex, in the primitive of the file, which may have others

  std::size_t number_of_vertices() const { return numbers.size(); }
};

struct Gltf_surface
{
  std::shared_ptr<const Gltf_file> file;
  std::vector<Gltf_primitive> primitives; // mesh by mesh
  std::vector<std::string> mesh_names;
  std::vector<Glb_material> materials;
  std::vector<std::string> remarks; // what is left out
  std::string scene_parts;   // what the surface alone does not have, such as "nodes and textures", or empty
  std::size_t instances = 0; // further places of meshes
  std::vector<std::string> files_beside; // that the file refers to
};

// Reads the content of a binary or textual glTF file. `file` is its name: other files that it refers to are beside it.
// A mesh with several nodes is there once, at the place of the first, unless each of them is to have its own. Throws an
// `Input_error` that names what is wrong.
Gltf_surface gltf_surface(std::string_view content, bool is_binary, const std::string& file,
                          const Gltf_options& options);

// New triangles of a primitive, whose vertices are some of its vertices: one for each place in the texture.
struct Gltf_triangles
{
  std::size_t primitive = 0;            // in `Gltf_surface::primitives`
  std::vector<std::uint32_t> vertices;  // of each new vertex, the one in the primitive of the file
  std::vector<float> texture;           // 2 of each, v goes down, or empty
  std::vector<std::uint32_t> triangles; // 3 new vertices each
};

struct Gltf_texture
{
  bool is_second_set = false;    // the first one stays
  bool has_tiny_picture = false; // which shows nothing, and refers to the new coordinates
};

// The file again, binary, with other triangles. Their texture coordinates are the first ones, or the second ones. Those
// that were there before come after them, and textures keep to them. Throws an `Output_error` if it is too large for
// the format.
std::string gltf_with_texture(const Gltf_file& file, const std::vector<Gltf_triangles>& triangles,
                              const Gltf_texture& texture, const std::string& output);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_SURFACE_H
