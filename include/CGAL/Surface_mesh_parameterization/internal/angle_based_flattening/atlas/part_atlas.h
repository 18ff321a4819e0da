// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_PART_ATLAS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_PART_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Atlas_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The charts of one connected part of a surface
struct Part_atlas
{
  std::string diagnosis, message; // empty, or why there are no charts
  Chart chart; // the part, opened along the seams; its triangles and corners are those of the part
  std::vector<Chart::Point_2> uv; // of each vertex of the chart, in the units of the surface
  std::vector<int> piece;         // of each triangle: the chart of the atlas that it is in
  int number_of_pieces = 1;
  Atlas_report::Method method = Atlas_report::ABF_PLUS_PLUS;
  Atlas_report::Seam_lengths seam_lengths = Atlas_report::NO_SEAMS;
  double contact = 0;
  int rounds = 0; // in which seams were added
  std::size_t number_of_terminals = 0;

  bool succeeded() const { return diagnosis.empty(); }
};

// How much more than the bound of `select_seams()` a map may stretch, as that predicts for another surface: the smooth one
inline constexpr double stretch_tolerance = 1.03;

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ATLAS_PART_ATLAS_H
