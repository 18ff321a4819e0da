// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_CANVAS_H
#define PICTURES_CANVAS_H

#include "pictures/Drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pictures {

// A picture of triangles with a depth buffer, which Cairo does not have.
class Canvas
{
public:
  static constexpr int number_of_values = 5;

  // A place in the picture, in pixels from the upper left, with values to interpolate.
  struct Corner
  {
    double x, y, depth; // larger is nearer
    std::array<double, number_of_values> values;
  };

  Canvas(const int width, const int height)
      : m_width(width), m_height(height),
        m_colors(static_cast<std::size_t>(width * samples) * static_cast<std::size_t>(height * samples),
                 Color{1, 1, 1}),
        m_depths(m_colors.size(), -std::numeric_limits<double>::infinity())
  {}

  int width() const { return m_width; }

  int height() const { return m_height; }

  // `color` is called with the interpolated values of each visible sample.
  template <class Shader>
  void draw_triangle(const Corner& a, const Corner& b, const Corner& c, const Shader& color)
  {
    const double area = cross(a, b, c.x, c.y);
    if(!(std::abs(area) > 1e-12)) { // too small to be seen, or not a number
      return;
    }
    const int left = first_sample((std::min)({a.x, b.x, c.x})),
              top = first_sample((std::min)({a.y, b.y, c.y}));
    const int right = last_sample((std::max)({a.x, b.x, c.x}), m_width);
    const int bottom = last_sample((std::max)({a.y, b.y, c.y}), m_height);
    for(int j = top; j <= bottom; ++j) {
      for(int i = left; i <= right; ++i) {
        const double x = (i + 0.5) / samples, y = (j + 0.5) / samples;
        const double u = cross(b, c, x, y) / area, v = cross(c, a, x, y) / area, w = 1 - u - v;
        if(u >= 0 && v >= 0 && w >= 0) {
          draw_sample(i, j, a, b, c, {u, v, w}, color);
        }
      }
    }
  }

  void draw_line(const Corner& a, const Corner& b, const double width, const Color& color)
  {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if(length == 0) {
      return;
    }
    const double dx = (b.x - a.x) / length * width / 2, dy = (b.y - a.y) / length * width / 2;
    const auto moved = [](const Corner& p, const double x, const double y) {
      return Corner{p.x + x, p.y + y, p.depth, {}};
    };
    const Corner p = moved(a, -dx - dy, dx - dy), q = moved(a, -dx + dy, -dx - dy);
    const Corner r = moved(b, dx - dy, dx + dy), s = moved(b, dx + dy, dy - dx);
    const auto shader = [&color](const std::array<double, number_of_values>&) { return color; };
    draw_triangle(p, q, r, shader);
    draw_triangle(q, s, r, shader);
  }

  // Fewer levels of each colour make files smaller.
  Pixels pixels(const int levels = 255) const
  {
    Pixels result{m_width, m_height, {}};
    for(int y = 0; y < m_height; ++y) {
      for(int x = 0; x < m_width; ++x) {
        std::uint32_t color = 0;
        for(const double part : averaged(x, y)) {
          const double level = std::round(levels * std::clamp(part, 0., 1.));
          color = 256 * color + static_cast<std::uint32_t>(std::lround(255 * level / levels));
        }
        result.colors.push_back(color);
      }
    }
    return result;
  }

  // The picture as a PNG file
  std::string png(const int levels = 255) const { return png_file(pixels(levels)); }

private:
  static constexpr int samples = 3; // per pixel, in each direction

  static double cross(const Corner& a, const Corner& b, const double x, const double y)
  {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  }

  static int first_sample(const double x)
  {
    return static_cast<int>((std::max)(0., std::floor((std::min)(x, 1e6) * samples - 0.5)));
  }

  static int last_sample(const double x, const int size)
  {
    return static_cast<int>((std::min)(size * samples - 1., std::ceil((std::max)(x, -1.) * samples)));
  }

  template <class Shader>
  void draw_sample(const int i, const int j, const Corner& a, const Corner& b, const Corner& c,
                   const std::array<double, 3>& weights, const Shader& color)
  {
    const auto sample = static_cast<std::size_t>(j) * static_cast<std::size_t>(m_width * samples) +
                        static_cast<std::size_t>(i);
    const double depth = weights[0] * a.depth + weights[1] * b.depth + weights[2] * c.depth;
    if(depth <= m_depths[sample]) {
      return;
    }
    std::array<double, number_of_values> values;
    for(std::size_t k = 0; k < values.size(); ++k) {
      values[k] = weights[0] * a.values[k] + weights[1] * b.values[k] + weights[2] * c.values[k];
    }
    m_depths[sample] = depth;
    m_colors[sample] = color(values);
  }

  Color averaged(const int x, const int y) const
  {
    Color sum = {0, 0, 0};
    for(int s = 0; s < samples * samples; ++s) {
      const int i = x * samples + s % samples, j = y * samples + s / samples;
      const Color& color =
          m_colors[static_cast<std::size_t>(j) * static_cast<std::size_t>(m_width * samples) +
                   static_cast<std::size_t>(i)];
      for(std::size_t k = 0; k < 3; ++k) {
        sum[k] += color[k] / (samples * samples);
      }
    }
    return sum;
  }

  int m_width, m_height;
  std::vector<Color> m_colors; // of each sample
  std::vector<double> m_depths;
};

} // namespace pictures

#endif // PICTURES_CANVAS_H
