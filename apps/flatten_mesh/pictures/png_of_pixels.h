// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_PNG_OF_PIXELS_H
#define FLATTEN_MESH_PNG_OF_PIXELS_H

#include <png.h>

#include <stdexcept>
#include <string>

namespace flatten_mesh {

// A picture as a PNG file, row by row from above. `format` is one of libpng's that fits the pixels.
inline std::string png_of_pixels(const int width, const int height, const png_uint_32 format,
                                 const void* pixels)
{
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(size, '\0');
  if(png_image_write_to_memory(&image, &file[0], &size, 0, pixels, 0, nullptr) == 0) {
    throw std::runtime_error(std::string("libpng: ") + image.message);
  }
  file.resize(size);
  return file;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_PNG_OF_PIXELS_H
