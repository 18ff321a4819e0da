// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECKERBOARD_PNG_H
#define FLATTEN_MESH_CHECKERBOARD_PNG_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/pictures/png_of_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

// A picture for a page: squares stay squares if the page has the sides that `--resolution` says. There is an even number
// of squares along each side, so that repeated pictures continue one another.
inline std::string checkerboard_png(const Atlas_command& atlas)
{
  constexpr int pixels = 16, most = 32; // of a square; squares along the longer side
  const double width = atlas.resolution, height = atlas.number_of_rows(),
               side = (std::max)(width, height) / most;
  const auto squares = [side](const double length) {
    return 2 * (std::max)(static_cast<int>(std::lround(length / side / 2)), 1);
  };
  const int columns = pixels * squares(width), rows = pixels * squares(height);
  std::vector<unsigned char> gray;
  gray.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for(int y = 0; y < rows; ++y) {
    for(int x = 0; x < columns; ++x) {
      gray.push_back((x / pixels + y / pixels) % 2 == 0 ? 230 : 90);
    }
  }
  return png_of_pixels(columns, rows, PNG_FORMAT_GRAY, gray.data());
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECKERBOARD_PNG_H
