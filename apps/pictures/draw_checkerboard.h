// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_DRAW_CHECKERBOARD_H
#define PICTURES_DRAW_CHECKERBOARD_H

#include "pictures/Canvas.h"
#include "pictures/Surface_view.h"
#include "pictures/Textured_surface.h"
#include "pictures/chart_colors.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pictures {

namespace internal {

// The light that falls on a surface with this normal, in the coordinates of the view
inline double brightness(const Kernel::Vector_3& normal)
{
  return 0.38 + 0.62 * std::abs(normal * Surface_view::normalized(Kernel::Vector_3(-0.35, 0.5, 0.8)));
}

// The paint of a square in the plane: light, or dark in the colour of the chart. What has no chart is red, and the back
// of the surface grey.
inline Color paint(const int chart, const double u, const double v, const bool is_behind)
{
  const Color light = {0.97, 0.96, 0.92}, behind = {0.62, 0.62, 0.62}, missing = {0.9, 0.25, 0.2};
  const bool is_odd = std::fmod(std::abs(std::floor(u) + std::floor(v)), 2) == 1;
  return mix(chart < 0 ? missing : is_odd ? color_of_chart(chart) : light, behind, is_behind ? 0.75 : 0.);
}

} // namespace internal

// Draws the surface with a checkerboard in the plane; the squares have the given side there.
inline void draw_checkerboard(Canvas& canvas, const Textured_surface& surface,
                              const std::vector<Kernel::Vector_3>& normals, const double side,
                              const Projection& projection)
{
  for(std::size_t t = 0; t < surface.triangles.size(); ++t) {
    std::array<Canvas::Corner, 3> corners;
    for(std::size_t i = 0; i < 3; ++i) {
      const Textured_surface::Index v = surface.triangles[t][i];
      const Kernel::Vector_3 normal = projection.view()(normals[v]);
      const Kernel::Point_2& uv = surface.uv[t][i];
      corners[i] = projection(surface.points[v]);
      corners[i].values = {uv.x() / side, uv.y() / side, normal.x(), normal.y(), normal.z()};
    }
    const int chart = surface.charts[t];
    canvas.draw_triangle(corners[0], corners[1], corners[2],
                         [chart](const std::array<double, Canvas::number_of_values>& values) {
                           const Kernel::Vector_3 normal =
                               Surface_view::normalized(Kernel::Vector_3(values[2], values[3], values[4]));
                           return mix(Color{0.03, 0.05, 0.1},
                                      internal::paint(chart, values[0], values[1], normal.z() < 0),
                                      internal::brightness(normal));
                         });
  }
}

// Draws the seams as dark lines, slightly in front of the surface.
inline void draw_seams(Canvas& canvas, const Textured_surface& surface, const double width,
                       const Projection& projection)
{
  const double in_front = 3; // in pixels
  const Color ink = {0.08, 0.02, 0.02};
  for(const Textured_surface::Border& border : surface.borders) {
    for(const Textured_surface::Side& side : border.sides) {
      if(side.seam >= 0) {
        const auto& triangle = surface.triangles[side.triangle];
        Canvas::Corner a = projection(surface.points[triangle[side.corner]]),
                       b = projection(surface.points[triangle[(side.corner + 1u) % 3]]);
        a.depth += in_front;
        b.depth += in_front;
        canvas.draw_line(a, b, width, ink);
      }
    }
  }
}

} // namespace pictures

#endif // PICTURES_DRAW_CHECKERBOARD_H
