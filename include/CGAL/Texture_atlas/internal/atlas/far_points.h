// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Stray points, which some scanners write. Faces there are left out of an atlas.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FAR_POINTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FAR_POINTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/vertex_names.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Texture_atlas::internal {

constexpr const char* far_point_text = "more than a billion times as far from the middle as most vertices";

// A sentence about vertices that are not finite, or far away, of which it names the first
inline std::string wrong_points_text(const std::string& first, std::size_t count, Diagnosis kind)
{
  std::string text = first;
  if(count > 1)
    text += " and " + std::to_string(count - 1) + (count > 2 ? " others" : " other");
  if(kind == Diagnosis::FAR_POINT)
    return text + (count > 1 ? " are " : " is ") + far_point_text;
  return text + (count > 1 ? " have coordinates that are not all finite numbers" : non_finite_text);
}

// Tells which points are so much farther from the middle than two thirds of all corners of faces that beside them
// nothing else could be seen. In each coordinate, the middle is the median. Corners are counted, and not vertices,
// because files have several vertices at one point, or some without faces.
class Far_points
{
public:
  typedef std::array<double, 3> Point;

  Far_points() = default; // there are none

  explicit Far_points(std::vector<Point> corners) // those that are not finite are not counted
  {
    corners.erase(
        std::remove_if(corners.begin(), corners.end(), [](const Point& p) { return !is_finite(p); }),
        corners.end());
    if(corners.empty())
      return;
    std::vector<double> numbers(corners.size());
    for(std::size_t i = 0; i < 3; ++i) {
      std::transform(corners.begin(), corners.end(), numbers.begin(), [i](const Point& p) { return p[i]; });
      m_middle[i] = quantile(numbers, 1. / 2);
    }
    std::transform(corners.begin(), corners.end(), numbers.begin(),
                   [this](const Point& p) { return distance(p); });
    m_distance = quantile(numbers, 2. / 3);
  }

  static bool is_finite(const Point& p)
  {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  }

  bool contain(const Point& p) const
  {
    return m_distance > 0 && is_finite(p) && distance(p) > 1e9 * m_distance;
  }

private:
  double distance(const Point& p) const
  {
    return (std::max)(
        {std::abs(p[0] - m_middle[0]), std::abs(p[1] - m_middle[1]), std::abs(p[2] - m_middle[2])});
  }

  static double quantile(std::vector<double>& numbers, double part) // changes their order
  {
    const auto place =
        numbers.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(numbers.size()));
    std::nth_element(numbers.begin(), place, numbers.end());
    return *place;
  }

  Point m_middle = {0, 0, 0};
  double m_distance = 0; // that two thirds have at most
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_ATLAS_FAR_POINTS_H
