// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PNG_TEXTURES_H
#define FLATTEN_MESH_PNG_TEXTURES_H

#include <CGAL/Surface_mesh_parameterization/Baked_textures.h>

#include <png.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace flatten_mesh {

namespace internal {

// Square pictures as PNG files. `format` is one of libpng's that fits the pixels.
inline std::string square_png(const int resolution, const png_uint_32 format, const void* pixels)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = static_cast<png_uint_32>(resolution);
  image.format = format;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(size, '\0');
  if(png_image_write_to_memory(&image, &file[0], &size, 0, pixels, 0, nullptr) == 0) {
    throw std::runtime_error(std::string("libpng: ") + image.message);
  }
  file.resize(size);
  return file;
}

} // namespace internal

// Red, green and blue are x, y and z, with 8 bits: 0 is -1, and 255 is 1.
inline std::string normals_png(const CGAL::Surface_mesh_parameterization::Baked_textures& textures)
{
  return internal::square_png(textures.resolution, PNG_FORMAT_RGB,
                              textures.normal_pixels<std::uint8_t>().data());
}

// Grey with 16 bits, from the least displacement to the greatest
inline std::string displacements_png(const CGAL::Surface_mesh_parameterization::Baked_textures& textures)
{
  return internal::square_png(textures.resolution, PNG_FORMAT_LINEAR_Y,
                              textures.displacement_pixels<std::uint16_t>().data());
}

inline std::string colors_png(const CGAL::Surface_mesh_parameterization::Baked_textures& textures)
{
  return internal::square_png(textures.resolution, PNG_FORMAT_RGB,
                              textures.color_pixels<std::uint8_t>().data());
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PNG_TEXTURES_H
