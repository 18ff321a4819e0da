// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_FLAT_POLYGON_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_FLAT_POLYGON_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// The corners of a polygon in space, and in the plane of two coordinates that its normal is farthest from. Leaving out
// a coordinate does not round: lines in space remain straight, unlike after a rotation.
class Flat_polygon
{
public:
  explicit Flat_polygon(std::vector<Kernel::Point_3> points) : m_points(std::move(points))
  {
    scale();
    const Kernel::Vector_3 normal = normal_of_area();
    const int axis = axis_to_leave_out(normal);
    const int x = (axis + 1) % 3, y = (axis + 2) % 3;
    for(const Kernel::Point_3& p : m_points) {
      m_plane.push_back(normal[axis] < 0 ? Kernel::Point_2(p[y], p[x]) : Kernel::Point_2(p[x], p[y]));
    }
  }

  Index size() const { return static_cast<Index>(m_points.size()); }
  const Kernel::Point_2& plane(const Index i) const { return m_plane[i]; }

  // In the plane, exactly
  CGAL::Orientation turn(const Index i, const Index j, const Index k) const
  {
    return CGAL::orientation(m_plane[i], m_plane[j], m_plane[k]);
  }

  // Twice the area of a triangle in space, as a vector
  Kernel::Vector_3 area(const Index i, const Index j, const Index k) const
  {
    return CGAL::cross_product(m_points[j] - m_points[i], m_points[k] - m_points[i]);
  }

  // The area of a triangle in space relative to its sides: as large as possible for equal ones
  double shape(const Index i, const Index j, const Index k) const
  {
    const double sides = (m_points[j] - m_points[i]).squared_length() +
                         (m_points[k] - m_points[j]).squared_length() +
                         (m_points[i] - m_points[k]).squared_length();
    return sides > 0 ? std::sqrt(area(i, j, k).squared_length()) / sides : 0;
  }

  // Of the angle at corner i in space; infinite if it is flat, and not a number without sides
  double cotangent(const Index i, const Index j, const Index k) const
  {
    const double product = (m_points[j] - m_points[i]) * (m_points[k] - m_points[i]);
    return product / std::sqrt(area(i, j, k).squared_length());
  }

private:
  // So that products neither overflow nor vanish. A power of two does not round.
  void scale()
  {
    double largest = 0;
    for(const Kernel::Point_3& p : m_points) {
      largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    }
    const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
    for(Kernel::Point_3& p : m_points) {
      p = Kernel::Point_3(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent),
                          std::ldexp(p.z(), exponent));
    }
  }

  // Newell's: twice the sum of the areas of a fan, as vectors
  Kernel::Vector_3 normal_of_area() const
  {
    Kernel::Vector_3 sum(0, 0, 0);
    for(Index i = 2; i < size(); ++i) {
      sum = sum + area(0, i - 1, i);
    }
    return sum;
  }

  // The coordinate in which the normal is longest. Without a normal, as for a figure of eight, the one in which the
  // polygon is shortest.
  int axis_to_leave_out(const Kernel::Vector_3& normal) const
  {
    std::array<double, 3> extent = {0, 0, 0};
    for(const Kernel::Point_3& p : m_points) {
      for(int axis = 0; axis < 3; ++axis) {
        extent[axis] = (std::max)(extent[axis], std::abs(p[axis] - m_points[0][axis]));
      }
    }
    const double largest = *std::max_element(extent.begin(), extent.end());
    const double rounding = 8 * std::numeric_limits<double>::epsilon() * size() * largest * largest;
    const std::array<double, 3> length = {std::abs(normal.x()), std::abs(normal.y()), std::abs(normal.z())};
    const auto longest = std::max_element(length.begin(), length.end());
    return static_cast<int>(*longest > rounding
                                ? longest - length.begin()
                                : std::min_element(extent.begin(), extent.end()) - extent.begin());
  }

  std::vector<Kernel::Point_3> m_points;
  std::vector<Kernel::Point_2> m_plane;
};

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_FLAT_POLYGON_H
