// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes prescribed angles into a chart: checks that they are possible, and corrects the largest one by the rounding
// error of the total. `chart/prescriptions.h` declares it. `run_parameterizer.h`, `cone_flattener.h` and
// `polygon_angles.h` include this body in programs without the compiled library, which has it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_SET_ANGLE_SUMS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_SET_ANGLE_SUMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_angle_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/check_surface_sums.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/prescriptions.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/seam_places.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Adds an angle to all copies of the largest sum.
inline void add_to_largest(double angle, const Seam_places& places, std::vector<double>& sums)
{
  const auto rank = [](double sum) { return std::isfinite(sum) ? sum : -1; };
  const auto largest =
      std::max_element(sums.begin(), sums.end(), [&](double a, double b) { return rank(a) < rank(b); });
  const int place = places.of(static_cast<int>(largest - sums.begin()));
  for(std::size_t v = 0; v < sums.size(); ++v)
    if(std::isfinite(sums[v]) && places.of(static_cast<int>(v)) == place)
      sums[v] += angle;
}

// The largest angle is corrected by the rounding error of the total; otherwise, the equations could not be satisfied.
CGAL_ANGLE_BASED_FLATTENING_INLINE Chart_defect set_angle_sums(std::vector<double> sums, Chart& chart)
{
  const Seam_places places(chart);
  (chart.equal_seams ? chart.surface_sums : chart.angle_sums) = std::move(sums);
  if(chart.equal_seams) {
    const Surface_sum_check check(chart);
    if(Chart_defect defect = check.run())
      return defect;
    add_to_largest(check.missing_angle(), places, chart.surface_sums);
  } else {
    const Angle_sum_check check(chart);
    if(Chart_defect defect = check.run())
      return defect;
    if(is_whole_border_prescribed(chart))
      add_to_largest(check.missing_angle(), places, chart.angle_sums);
  }
  find_nodes(chart);
  return {};
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_SET_ANGLE_SUMS_H
