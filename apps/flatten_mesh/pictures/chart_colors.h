// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHART_COLORS_H
#define FLATTEN_MESH_CHART_COLORS_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace flatten_mesh {

// The colour of a chart, from 0 on. Those of neighbouring numbers differ much.
inline std::array<double, 3> color_of_chart(const int chart)
{
  const double golden_angle = 0.381966; // of a turn
  const double hue = std::fmod(0.58 + golden_angle * chart, 1.) * 6, darkest = 0.13, brightest = 0.57;
  std::array<double, 3> color;
  for(std::size_t i = 0; i < 3; ++i) {
    const double distance = std::abs(std::fmod(hue + std::array<double, 3>{0, 4, 2}[i], 6.) - 3) - 1;
    color[i] = darkest + (brightest - darkest) * std::clamp(distance, 0., 1.);
  }
  return color;
}

// Of a chart in the plane: lighter than on the surface
inline std::array<unsigned char, 3> light_color_of_chart(const int chart)
{
  std::array<unsigned char, 3> color;
  std::size_t i = 0;
  for(const double part : color_of_chart(chart)) {
    color[i++] = static_cast<unsigned char>(std::lround(255 * (0.55 + 0.45 * part)));
  }
  return color;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHART_COLORS_H
