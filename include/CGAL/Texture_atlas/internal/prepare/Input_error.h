// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_INPUT_ERROR_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_INPUT_ERROR_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// An error that the user has to correct, in a file or in arguments. The text is one line that names the error
// and the remedy.
struct Input_error : public std::runtime_error
{
  std::vector<std::size_t> faces, vertices; // of the file, from 0, that the text names

  Input_error(const std::string& text, std::vector<std::size_t> faces = {},
              std::vector<std::size_t> vertices = {})
      : std::runtime_error(text), faces(std::move(faces)), vertices(std::move(vertices))
  {}
};

// Vertices and faces counted from 1, as in OBJ files.
inline std::string vertex_name(const std::size_t index)
{
  return "vertex " + std::to_string(index + 1);
}

inline std::string face_name(const std::size_t index)
{
  return "face " + std::to_string(index + 1);
}

// A count with its noun: "1 border", "3 borders".
inline std::string count_text(const std::size_t count, const std::string& noun,
                              const std::string& plural = "")
{
  return std::to_string(count) + " " + (count == 1 ? noun : plural.empty() ? noun + "s" : plural);
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_INPUT_ERROR_H
