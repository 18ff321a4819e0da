// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a method returns for a chart: coordinates, or the reason why there are none.
// The methods of `strategies/`, the injective maps and the parameterizers pass it on.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FLATTENING_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FLATTENING_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The planar angles of a map, and the multipliers of their constraints: where a later run on the same triangles can
// start
struct Planar_angles
{
  std::vector<int> vertex, node;   // as in the chart: of the same triangles and constraints
  std::vector<double> beta, alpha; // the target angles and the planar ones, of each corner
  std::vector<double> multipliers;
};

// The map of a chart, or why there is none.
template <typename Report>
struct Flattening
{
  std::vector<Chart::Point_2> uv;
  std::vector<int> invalid;            // the triangles that make the map invalid, if that is what is wrong
  std::vector<int> offending_vertices; // those of pins to which no valid map was found
  Report report;
  std::shared_ptr<const Planar_angles> angles; // if they were asked for

  bool succeeded() const { return report.status == Diagnosis::NOTHING_WRONG; }
};

// Rounds coordinates to what the caller can store.
typedef void (*Rounding)(std::vector<Chart::Point_2>&);

// Flattens a coarse chart. Returns nothing if it fails.
typedef std::function<std::optional<std::vector<Chart::Point_2>>(const Chart&)> Coarse_flattening;

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FLATTENING_H
