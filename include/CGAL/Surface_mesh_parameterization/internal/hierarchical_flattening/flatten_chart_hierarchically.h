// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_FLATTEN_CHART_HIERARCHICALLY_H
#define CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_FLATTEN_CHART_HIERARCHICALLY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/flatten_from_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/report_failure.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/stopwatch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_hierarchically.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/polish.h>

#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

inline bool certify_hierarchical(const Chart& chart, const Hierarchical_options& options,
                                 const Rounding& round, std::vector<Chart::Point_2>& uv,
                                 std::vector<int>& flipped, Hierarchical_report& report)
{
  Stopwatch stopwatch;
  visit_stage(options.visitor, Flattening_visitor::CERTIFY);
  scale_to_surface_area(chart, uv);
  round(uv);
  const bool valid = inspect(chart, uv, report, flipped);
  report.seconds.certify = stopwatch.lap();
  if(!valid)
    fail(report, ERROR_NO_1_TO_1_MAPPING, ABF_plus_plus_report::PRECISION_EXCEEDED,
         "there is a valid map, but rounded to the coordinates' number type it has " +
             describe_invalid(chart, flipped, report));
  return valid;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE bool
flatten_chart_hierarchically(Chart& chart, const Hierarchical_options& options,
                             const Coarse_flattening& flatten_coarse, const Linear_solvers& solvers,
                             const Rounding& round, std::vector<Chart::Point_2>& uv,
                             std::vector<int>& flipped, Hierarchical_report& report)
{
  if(!flatten_hierarchically(chart, options, flatten_coarse, uv, report)) {
    if(chart.borders.size() > 1)
      fail(report, ERROR_NO_1_TO_1_MAPPING, ABF_plus_plus_report::NO_CONVERGENCE,
           "no coarse chart could be flattened, and with several borders there is no other start");
    else
      fail(report, ERROR_NO_1_TO_1_MAPPING, ABF_plus_plus_report::PRECISION_EXCEEDED,
           "double precision does not hold any valid map that was tried");
    return false;
  }
  if(options.polish) {
    Stopwatch stopwatch;
    visit_stage(options.visitor, Flattening_visitor::POLISH);
    polish(chart, options, solvers, uv, report);
    report.seconds.polish = stopwatch.lap();
  }
  return certify_hierarchical(chart, options, round, uv, flipped, report);
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_FLATTEN_CHART_HIERARCHICALLY_H
