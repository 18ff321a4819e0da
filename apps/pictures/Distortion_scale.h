// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef PICTURES_DISTORTION_SCALE_H
#define PICTURES_DISTORTION_SCALE_H

#include "pictures/Drawing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace pictures {

// Colours on a logarithmic scale of a few whole decades, from dark blue for small numbers over green to light yellow
// for large ones.
class Distortion_scale
{
public:
  static constexpr int number_of_colors = 64;

  // The scale covers nearly all values. The others get the colours of the ends.
  explicit Distortion_scale(std::vector<double> values)
  {
    values.erase(std::remove_if(values.begin(), values.end(), [](const double x) { return !(x > 1e-30); }),
                 values.end());
    if(!values.empty()) {
      m_first_decade = static_cast<int>(std::floor(std::log10(quantile(values, 0.05))));
      m_last_decade = static_cast<int>(std::ceil(std::log10(quantile(values, 0.99))));
    }
    m_last_decade = (std::max)(m_last_decade, m_first_decade + 2);
    m_first_decade = (std::max)(m_first_decade, m_last_decade - 6);
  }

  int first_decade() const { return m_first_decade; }

  int last_decade() const { return m_last_decade; }

  int color_index(const double value) const
  {
    const double decade = value > 1e-30 ? std::log10(value) : m_first_decade;
    const double part = (decade - m_first_decade) / (m_last_decade - m_first_decade);
    return (std::min)((std::max)(static_cast<int>(part * number_of_colors), 0), number_of_colors - 1);
  }

  // Lightness increases evenly, so equal differences look equal, also in grey.
  static Color color(const int index)
  {
    const double part = (index + 0.5) / number_of_colors;
    const double lightness = 0.30 + 0.63 * part;
    const double chroma = 0.12 + 0.05 * part;
    const double hue = (285. - 185. * part) * 3.14159265358979 / 180.;
    return oklab_color(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
  }

private:
  static double quantile(std::vector<double>& values, const double part)
  {
    const auto nth =
        values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
  }

  // Converts a colour from Oklab, where distances are visual differences, to sRGB.
  static Color oklab_color(const double lightness, const double a, const double b)
  {
    const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
    const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
    const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
    return {srgb(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            srgb(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            srgb(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
  }

  static double srgb(const double linear)
  {
    const double x = std::clamp(linear, 0., 1.);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1. / 2.4) - 0.055;
  }

  int m_first_decade = -6;
  int m_last_decade = -4;
};

} // namespace pictures

#endif // PICTURES_DISTORTION_SCALE_H
