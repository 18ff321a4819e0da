// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Asks exact predicates whether a map is one-to-one.
// This is the body of `one_to_one.h`. The theorem behind it is in `planar_map.h`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_ONE_TO_ONE_IMPL_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_ONE_TO_ONE_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/one_to_one.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

CGAL_ANGLE_BASED_FLATTENING_INLINE bool is_one_to_one(const Chart& chart,
                                                      const std::vector<Chart::Point_2>& uv)
{
  const std::vector<Exact_point_2> points = exact_points(uv);
  return flipped_triangles(chart.vertex, points).empty() && bounds_region(border_edges(chart), points);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CERTIFICATE_ONE_TO_ONE_IMPL_H
