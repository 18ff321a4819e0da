// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The direct method with its fallbacks: from the surface's angles, with a raised barrier, and from a progressive
// embedding. `flatten_chart_directly.h` runs it on disks, and `hole_strategies.h` extends it. The paper has the first
// attempt only (Algorithm 18).

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_DIRECT_STRATEGIES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_DIRECT_STRATEGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_from_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/optional_strategies.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The strategies of the direct method, one after the other until one gives a valid map. A feasible chart with one
// border has a valid map, which the last one finds unless the range of numbers is too small for it.
class Direct_strategies
{
  typedef ABF_plus_plus_report Report;

public:
  // The map is that of `part`, the chart itself or its first vertices and triangles.
  Direct_strategies(const Chart& chart, const Chart& part, const ABF_plus_plus_options& options,
                    const Linear_solvers& solvers, Rounding round)
      : m_chart(chart), m_part(part), m_options(options), m_solvers(solvers), m_round(round)
  {}

  Flattening<Report> run()
  {
    {
      const Stage stage(m_options.visitor, Flattening_visitor::TARGET_ANGLES, m_seconds.targets);
      m_beta = target_angles(m_chart);
    }
    Direct_flattening result = flatten(m_options, starting_angles(m_beta));
    if(m_options.fallbacks && can_fallbacks_help(result)) {
      note_failure(result);
      result = raise_barrier();
      if(!result.succeeded())
        result = start_from_embedding(std::move(result));
    }
    return finished(std::move(result));
  }

protected:
  Flattening<Report> finished(Direct_flattening result)
  {
    result.report.failed_strategies = std::move(m_failed);
    result.report.seconds = m_seconds;
    if(result.succeeded())
      report_seams(m_part, result.uv, result.report);
    return Flattening<Report>(std::move(result));
  }

  // Where the solver itself fails, or is asked for something impossible, other angles do not help.
  static bool can_fallbacks_help(const Direct_flattening& result)
  {
    return result.report.status == Diagnosis::NO_CONVERGENCE ||
           result.report.status == Diagnosis::FLIPPED_TRIANGLES;
  }

  void note_failure(const Direct_flattening& result)
  {
    const Report& report = result.report;
    m_failed.push_back({report.strategy, report.status, report.message, report.iterations});
  }

  Direct_flattening flatten(const ABF_plus_plus_options& options, std::vector<double> start)
  {
    Direct_flattening result =
        flatten_from_angles(m_chart, m_part, options, m_solvers, m_round, m_beta, std::move(start));
    m_seconds += result.report.seconds;
    return result;
  }

  // A high barrier keeps angles away from zero. It is then lowered again; if that fails, the angles with the high
  // barrier remain.
  Direct_flattening raise_barrier()
  {
    ABF_plus_plus_options raised = m_options;
    raised.barrier = (std::max)(3., 30 * m_options.barrier);
    Direct_flattening result = flatten(raised, starting_angles(m_beta));
    if(result.succeeded()) {
      Direct_flattening lowered = flatten(m_options, std::move(result.alpha));
      if(lowered.succeeded() && lowered.report.converged)
        result = std::move(lowered);
    }
    result.report.strategy = Report::RAISED_BARRIER;
    return result;
  }

  // The last strategy
  Direct_flattening start_from_embedding(Direct_flattening failed)
  {
    if(optional_strategies.embed_progressively == nullptr) {
      fail(failed.report, failed.report.status,
           needs_strategies(failed.report.message + "; the last fallback"));
      return failed;
    }
    note_failure(failed);
    std::optional<std::vector<Chart::Point_2>> embedding =
        optional_strategies.embed_progressively(m_chart, m_options);
    if(!embedding) {
      Direct_flattening result;
      result.report = report_of<Report>(m_part);
      result.report.strategy = Report::FROM_PROGRESSIVE_EMBEDDING;
      fail(result.report, Diagnosis::PRECISION_EXCEEDED, "no valid map was found in double precision");
      return result;
    }
    std::vector<double> alpha(m_beta.size());
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      alpha[c] = planar_angle(m_chart, *embedding, c);
    Direct_flattening result = flatten(m_options, starting_angles(alpha));
    result.report.strategy = Report::FROM_PROGRESSIVE_EMBEDDING;
    if(result.succeeded() && result.report.converged)
      return result;
    if(result.succeeded())
      fail(result.report, Diagnosis::NO_CONVERGENCE, "the angles did not converge");
    if(m_part.has_prescribed_angles()) // the embedding knows nothing of them
      return result;
    note_failure(result);
    embedding->resize(m_part.points.size());
    return take_embedding(*embedding);
  }

  // Near the limits of precision rounding by the scale to the surface's area is too much; a power of two rounds
  // nothing.
  Direct_flattening take_embedding(const std::vector<Chart::Point_2>& embedding)
  {
    std::vector<Chart::Point_2> uv = embedding;
    scale_to_surface_area(m_part, uv);
    Direct_flattening result = certified(std::move(uv));
    if(result.succeeded())
      return result;
    const double factor = power_of_two(scale_to_surface(m_part, embedding));
    uv = embedding;
    for(Chart::Point_2& p : uv)
      p = CGAL::ORIGIN + (p - CGAL::ORIGIN) * factor;
    return certified(std::move(uv));
  }

  Direct_flattening certified(std::vector<Chart::Point_2> uv)
  {
    Direct_flattening result;
    result.report = report_of<Report>(m_part);
    result.report.strategy = Report::PROGRESSIVE_EMBEDDING;
    m_round(uv);
    Certificate certificate = certify(m_part, uv);
    take_certificate(certificate, result.report);
    if(!certificate.is_valid())
      fail(result.report, Diagnosis::PRECISION_EXCEEDED,
           "the map is valid, but after rounding to the coordinates' number type it has " +
               describe_invalid(m_part, certificate));
    result.invalid = std::move(certificate.invalid);
    result.uv = std::move(uv);
    return result;
  }

  const Chart& m_chart;
  const Chart& m_part;
  const ABF_plus_plus_options& m_options;
  const Linear_solvers& m_solvers;
  const Rounding m_round;
  std::vector<double> m_beta;
  std::vector<Report::Failed_strategy> m_failed;
  Report::Seconds m_seconds;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_DIRECT_STRATEGIES_H
