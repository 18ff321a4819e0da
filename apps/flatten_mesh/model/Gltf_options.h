// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_OPTIONS_H
#define FLATTEN_MESH_GLTF_OPTIONS_H

namespace flatten_mesh {

// How a glTF file is read
struct Gltf_options
{
  bool unique_instances = false;   // each node gets a mesh of its own
  bool joins_vertices = true;      // that the format splits where their normals or texture coordinates differ
  bool keeps_scene = true;         // the output is glTF as well, and has what the surface alone does not have
  bool transforms_texture = false; // first coordinates are those that KHR_texture_transform makes of them
};

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_OPTIONS_H
