// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds border cycles and interior vertices of a corner table, and decides which vertices get the equations of Eqs. 3
// and 4. Called wherever a chart is made or changed: by the readers, for filled holes, coarse charts and patches.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FIND_BORDERS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FIND_BORDERS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The vertices of the outer border that have prescribed angles
CGAL_ANGLE_BASED_FLATTENING_INLINE std::vector<int> vertices_with_prescribed_angles(const Chart& chart);

// Whether the whole outer border is prescribed. Then the equations of all vertices sum up to that of all triangles.
CGAL_ANGLE_BASED_FLATTENING_INLINE bool is_whole_border_prescribed(const Chart& chart);

// Makes the interior vertices the constraint nodes, those of seams and those with prescribed angles, and those of the
// holes.
CGAL_ANGLE_BASED_FLATTENING_INLINE void find_nodes(Chart& chart);

// Makes the sides of the seams on the outer border equal, if there are seams, and finds the nodes.
CGAL_ANGLE_BASED_FLATTENING_INLINE void equalize_outer_seams(Chart& chart);

// Finds `borders`, `interior`, `number_of_interior_vertices` and the constraint nodes from `vertex` and `opposite`. The
// first border cycle is the one with the edge that `first_border` faces, if that is not negative; the others are holes.
CGAL_ANGLE_BASED_FLATTENING_INLINE void find_borders(Chart& chart, int first_border = -1);

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders_impl.h>
#endif

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FIND_BORDERS_H
