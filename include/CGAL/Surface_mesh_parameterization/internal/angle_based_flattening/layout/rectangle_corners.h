// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Which vertices of the border are the corners of a rectangle with a given ratio of its sides, without a map.
// `polygon_angles.h` calls `choose_rectangle_corners()`; the definition is in `rectangle_corners_impl.h`.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_CORNERS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_CORNERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>

#include <array>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

struct Rectangle_corners
{
  Chart_defect defect;
  std::array<int, 4> vertices = {-1, -1, -1, -1}; // counterclockwise
  double aspect_ratio = 0; // predicted: of the side from the first corner to the second one to the next side
};

// Of the two possible first corners, the one that comes first on the outer border.
CGAL_ANGLE_BASED_FLATTENING_INLINE Rectangle_corners choose_rectangle_corners(const Chart& chart,
                                                                              double aspect_ratio,
                                                                              const Linear_solvers& solvers);

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/layout/rectangle_corners_impl.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LAYOUT_RECTANGLE_CORNERS_H
