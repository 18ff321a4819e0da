// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONES_CUT_OPEN_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONES_CUT_OPEN_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>

#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// A surface cut open along the edges that corners with `is_seam` face. Its corners are the same; a vertex on a seam becomes several ones.
inline Chart cut_open(const Chart& surface, const std::vector<char>& is_seam)
{
  Chart chart;
  chart.scale = surface.scale;
  chart.opposite = surface.opposite;
  chart.seam.assign(surface.opposite.size(), -1);
  for(int c = 0; c < surface.number_of_corners(); ++c)
    if(is_seam[c])
      std::swap(chart.opposite[c], chart.seam[c]);
  chart.vertex.assign(surface.vertex.size(), -1);
  for(int corner = 0; corner < surface.number_of_corners(); ++corner)
    if(chart.vertex[corner] < 0) {
      for(int c : corners_around(chart, corner))
        chart.vertex[c] = chart.number_of_vertices();
      chart.points.push_back(surface.points[surface.vertex[corner]]);
    }
  find_borders(chart);
  return chart;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CONES_CUT_OPEN_H
