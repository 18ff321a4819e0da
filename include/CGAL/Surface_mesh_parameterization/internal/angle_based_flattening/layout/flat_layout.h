// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Flat surfaces in their own plane. `atlas/flatten_part.h` takes them as maps, and `seams/crease_patches.h` as
// layouts.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_FLAT_LAYOUT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_FLAT_LAYOUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <CGAL/Origin.h>

#include <cmath>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Twice as long as the area is large
inline Corner_table::Kernel::Vector_3 triangle_normal(const Corner_table& table, int t)
{
  const auto& p = table.points[table.vertex[3 * t]];
  return CGAL::cross_product(table.points[table.vertex[3 * t + 1]] - p,
                             table.points[table.vertex[3 * t + 2]] - p);
}

// Looks whether some triangles lie in a plane, with the same side up.
class Flat_layout
{
  typedef Corner_table::Kernel::Vector_3 Vector_3;

public:
  Flat_layout(const Corner_table& table, const std::vector<int>& triangles)
      : m_origin(table.points[table.vertex[3 * triangles.front()]])
  {
    Vector_3 normal = CGAL::NULL_VECTOR;
    for(int t : triangles)
      normal = normal + triangle_normal(table, t);
    if(!(normal.squared_length() > 0))
      return;
    normal = unit(normal);
    m_x =
        unit(CGAL::cross_product(std::abs(normal.x()) < 0.6 ? Vector_3(1, 0, 0) : Vector_3(0, 1, 0), normal));
    m_y = CGAL::cross_product(normal, m_x);
    for(int t : triangles) {
      const Vector_3 n = triangle_normal(table, t);
      if(!(n * normal > least_cosine * std::sqrt(n.squared_length())))
        return;
    }
    m_is_flat = true;
  }

  bool is_flat() const { return m_is_flat; }

  Corner_table::Point_2 operator()(const Corner_table::Point_3& p) const
  {
    return Corner_table::Point_2((p - m_origin) * m_x, (p - m_origin) * m_y);
  }

private:
  static constexpr double least_cosine = 1 - 1e-4; // changes angles by less than 0.003 degrees

  static Vector_3 unit(const Vector_3& v) { return v / std::sqrt(v.squared_length()); }

  Corner_table::Point_3 m_origin;
  Vector_3 m_x, m_y;
  bool m_is_flat = false;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_FLAT_LAYOUT_H
