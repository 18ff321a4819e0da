// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMPARE_TEST_MESH_H
#define COMPARE_TEST_MESH_H

#include "Command_line.h"

#include <cstddef>
#include <string>
#include <vector>

namespace compare {

struct Test_mesh
{
  std::string name, file; // no file: the base is yet to be resized
  std::size_t triangles;

  bool resized() const { return file.empty(); }
};

// Those of the command line that are disks, small ones first. Throws an exception if a file that is named there is none.
std::vector<Test_mesh> find_meshes(const Command_line& command);

// Writes the base with about `triangles` triangles, and noise, to a file in the folder, whose name is returned.
std::string write_resized_mesh(const Command_line& command, std::size_t triangles, const std::string& folder);

} // namespace compare

#endif // COMPARE_TEST_MESH_H
