// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is left when all other strategies have failed: the direct method from a progressive embedding, and the embedding
// itself. `disk_strategies.h` enters it for `direct_strategies.h`: only programs with these strategies compile it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_EMBEDDING_STRATEGY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_EMBEDDING_STRATEGY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/direct_strategies.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_from_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/optional_strategies.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// `uv` if it is valid after rounding
inline Direct_flattening certified_embedding(const Direct_task& task, std::vector<Chart::Point_2> uv)
{
  Direct_flattening result;
  result.report = report_of<ABF_plus_plus_report>(task.part);
  result.report.strategy = ABF_plus_plus_report::PROGRESSIVE_EMBEDDING;
  task.round(uv);
  Certificate certificate = certify(task.part, uv);
  take_certificate(certificate, result.report);
  if(!certificate.is_valid())
    fail(result.report, Diagnosis::PRECISION_EXCEEDED,
         "the map is valid, but after rounding to the coordinates' number type it has " +
             describe_invalid(task.part, certificate));
  result.invalid = std::move(certificate.invalid);
  result.uv = std::move(uv);
  return result;
}

// Near the limits of precision rounding by the scale to the surface's area is too much; a power of two rounds
// nothing.
inline Direct_flattening take_embedding(const Direct_task& task, const std::vector<Chart::Point_2>& embedding)
{
  std::vector<Chart::Point_2> uv = embedding;
  scale_to_surface_area(task.part, uv);
  Direct_flattening result = certified_embedding(task, std::move(uv));
  if(result.succeeded())
    return result;
  const double factor = power_of_two(scale_to_surface(task.part, embedding));
  uv = embedding;
  for(Chart::Point_2& p : uv)
    p = CGAL::ORIGIN + (p - CGAL::ORIGIN) * factor;
  return certified_embedding(task, std::move(uv));
}

// Newton's method from the angles of a progressive embedding, and else the embedding itself
inline Direct_flattening flatten_from_embedding(Direct_strategies& strategies, const Direct_task& task,
                                                Attempts& attempts)
{
  std::optional<std::vector<Chart::Point_2>> embedding = progressive_embedding(task.chart, task.options);
  if(!embedding) {
    Direct_flattening result;
    result.report = report_of<ABF_plus_plus_report>(task.part);
    result.report.strategy = ABF_plus_plus_report::FROM_PROGRESSIVE_EMBEDDING;
    fail(result.report, Diagnosis::PRECISION_EXCEEDED, "no valid map was found in double precision");
    return result;
  }
  std::vector<double> alpha(strategies.target_angles().size());
  for(int c = 0; c < task.chart.number_of_corners(); ++c)
    alpha[c] = planar_angle(task.chart, *embedding, c);
  Direct_flattening result = strategies.flatten(task.options, starting_angles(alpha),
                                                ABF_plus_plus_report::FROM_PROGRESSIVE_EMBEDDING);
  if(result.succeeded() && result.report.converged)
    return result;
  if(result.succeeded())
    fail(result.report, Diagnosis::NO_CONVERGENCE, "the angles did not converge");
  if(task.part.has_prescribed_angles()) // the embedding knows nothing of them
    return result;
  attempts.note_failure(result);
  embedding->resize(task.part.points.size());
  return take_embedding(task, *embedding);
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_EMBEDDING_STRATEGY_H
