// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PNG_TEXTURES_H
#define FLATTEN_MESH_PNG_TEXTURES_H

#include "flatten_mesh/pictures/png_of_pixels.h"

#include <CGAL/Texture_atlas/Baked_textures.h>

#include <cstdint>
#include <string>

namespace flatten_mesh {

// Red, green and blue are x, y and z, with 8 bits: 0 is -1, and 255 is 1.
inline std::string normals_png(const CGAL::Texture_atlas::Baked_textures& textures)
{
  return png_of_pixels(textures.resolution, textures.height, PNG_FORMAT_RGB,
                       textures.normal_pixels<std::uint8_t>().data());
}

// Grey with 16 bits, from the least displacement to the greatest
inline std::string displacements_png(const CGAL::Texture_atlas::Baked_textures& textures)
{
  return png_of_pixels(textures.resolution, textures.height, PNG_FORMAT_LINEAR_Y,
                       textures.displacement_pixels<std::uint16_t>().data());
}

inline std::string colors_png(const CGAL::Texture_atlas::Baked_textures& textures)
{
  return png_of_pixels(textures.resolution, textures.height, PNG_FORMAT_RGB,
                       textures.color_pixels<std::uint8_t>().data());
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PNG_TEXTURES_H
