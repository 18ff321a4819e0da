// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef HIERARCHICAL_TEST_MESHES_H
#define HIERARCHICAL_TEST_MESHES_H

#include "Command_line.h"
#include "Runner.h"

#include "../common/Temporary_folder.h"
#include "../common/add_noise.h"
#include "../common/resize_mesh.h"

#include <cstddef>
#include <string>

namespace hierarchical {

typedef benchmarks::Mesh Mesh;

// A mesh of about so many triangles in a temporary file, made from the mesh of the command line
inline std::string resized_mesh(const Command_line& command, const Temporary_folder& folder,
                                const std::size_t triangles, const bool noise = false)
{
  Mesh mesh = resize_mesh(read_mesh(command.mesh), triangles);
  if(noise) {
    add_noise(mesh);
  }
  const std::string file = folder.file(name_of_file(command.mesh) + "_" +
                                       std::to_string((mesh.number_of_faces() + 500) / 1000) + "k.ply");
  write_mesh(mesh, file);
  return file;
}

} // namespace hierarchical

#endif // HIERARCHICAL_TEST_MESHES_H
