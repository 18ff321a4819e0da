// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_COLOR_SPACES_H
#define FLATTEN_MESH_COLOR_SPACES_H

#include "flatten_mesh/model/Model.h"

#include <cmath>
#include <cstddef>

namespace flatten_mesh {

// Colours of points are sRGB in OBJ, OFF and PLY files, as in pictures, and linear in glTF files. Both functions are
// those of IEC 61966-2-1. Opacities stay.
inline Point_color srgb_of_linear(Point_color color)
{
  for(std::size_t i = 0; i < 3; ++i) {
    color[i] = color[i] <= 0.0031308 ? 12.92 * color[i] : 1.055 * std::pow(color[i], 1 / 2.4) - 0.055;
  }
  return color;
}

inline Point_color linear_of_srgb(Point_color color)
{
  for(std::size_t i = 0; i < 3; ++i) {
    color[i] = color[i] <= 0.04045 ? color[i] / 12.92 : std::pow((color[i] + 0.055) / 1.055, 2.4);
  }
  return color;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_COLOR_SPACES_H
