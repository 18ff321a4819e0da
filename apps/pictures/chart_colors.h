// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_CHART_COLORS_H
#define PICTURES_CHART_COLORS_H

#include "pictures/Drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pictures {

// The colour of a chart, from 0 on. Those of neighbouring numbers differ much.
inline Color color_of_chart(const int chart)
{
  const double golden_angle = 0.381966; // of a turn
  const double hue = std::fmod(0.58 + golden_angle * chart, 1.) * 6, darkest = 0.13, brightest = 0.57;
  Color color;
  for(std::size_t i = 0; i < 3; ++i) {
    const double distance = std::abs(std::fmod(hue + std::array<double, 3>{0, 4, 2}[i], 6.) - 3) - 1;
    color[i] = darkest + (brightest - darkest) * std::clamp(distance, 0., 1.);
  }
  return color;
}

// Of a chart in the plane: lighter than on the surface
inline Color light_color_of_chart(const int chart)
{
  return mix(color_of_chart(chart), {1, 1, 1}, 0.55);
}

// Bright colours. Those of neighbouring numbers differ much.
inline Color color_of_seam(const int number)
{
  const double golden_angle = 0.381966; // of a turn
  const double hue = std::fmod(golden_angle * number, 1.) * 6;
  Color color = {0, 4, 2};
  for(double& part : color) {
    part = std::clamp(std::abs(std::fmod(hue + part, 6.) - 3) - 1, 0., 1.);
  }
  return color;
}

} // namespace pictures

#endif // PICTURES_CHART_COLORS_H
