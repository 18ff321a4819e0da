// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_GLTF_FILE_H
#define FLATTEN_MESH_GLTF_FILE_H

#include "flatten_mesh/texts.h"

#include <tiny_gltf.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

struct Gltf_file
{
  std::string name;
  std::vector<std::string> files_beside;         // that it refers to
  tinygltf::Model model;                         // without the bytes of buffers and pictures
  std::vector<std::vector<unsigned char>> bytes; // of each buffer
  std::vector<std::pair<int, int>> primitives;   // those of `Gltf_surface`: the mesh, and the number in it
};

[[noreturn]] inline void refuse_gltf(const std::string& file, const std::string& what)
{
  throw Input_error("'" + file + "': " + what + "; export the mesh again");
}

// The element with this number, or an `Input_error` that says what names it
template <class Element>
const Element& gltf_element(const Gltf_file& file, const std::vector<Element>& elements, const int number,
                            const std::string& from, const char* const noun)
{
  if(number < 0 || static_cast<std::size_t>(number) >= elements.size()) {
    refuse_gltf(file.name, from + " names " + noun + ' ' + std::to_string(number) +
                               ", which does not exist: the file has " + std::to_string(elements.size()));
  }
  return elements[static_cast<std::size_t>(number)];
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_GLTF_FILE_H
