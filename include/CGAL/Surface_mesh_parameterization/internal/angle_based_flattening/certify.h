// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>

#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// The triangles that are not positively oriented in the plane, by an exact predicate. Coordinates that are not
// finite make a triangle count as flipped.
inline std::vector<int> flipped_triangles(const Chart& chart, const std::vector<Chart::Point_2>& uv)
{
  std::vector<int> flipped;
  for(int t = 0; t < chart.number_of_triangles(); ++t) {
    const Chart::Point_2 &p = uv[chart.vertex[3 * t]], &q = uv[chart.vertex[3 * t + 1]],
                         &r = uv[chart.vertex[3 * t + 2]];
    const bool finite = CGAL::is_finite(p.x()) && CGAL::is_finite(p.y()) && CGAL::is_finite(q.x()) &&
                        CGAL::is_finite(q.y()) && CGAL::is_finite(r.x()) && CGAL::is_finite(r.y());
    if(!finite || CGAL::orientation(p, q, r) != CGAL::LEFT_TURN)
      flipped.push_back(t);
  }
  return flipped;
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFY_H
