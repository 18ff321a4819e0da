// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The strategies of the direct method, each on its own: from the angles of the surface or of an earlier map, with a
// raised barrier, and from a progressive embedding. `flatten_chart_directly.h` tries them on disks, and
// `hole_strategies.h` on charts with holes. The paper has the first only (Algorithm 18).

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_DIRECT_STRATEGIES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_DIRECT_STRATEGIES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/constraints.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/solve_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_shape.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/lay_out_angles.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart_hierarchically.h>
#endif

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// What every strategy is asked for: the map of `part`, which is `chart` itself or its first vertices and triangles
struct Direct_task
{
  const Chart& chart;
  const Chart& part;
  const ABF_plus_plus_options& options;
  const Linear_solvers& solvers;
  Rounding round;
};

// Where the solver itself fails, or is asked for something impossible, other angles do not help.
inline bool can_fallbacks_help(const Direct_flattening& result)
{
  return result.report.status == Diagnosis::NO_CONVERGENCE ||
         result.report.status == Diagnosis::FLIPPED_TRIANGLES;
}

// The strategies that failed so far, and the time that all of them took
struct Attempts
{
  std::vector<ABF_plus_plus_report::Failed_strategy> failed;
  ABF_plus_plus_report::Seconds seconds;

  void note_failure(const Direct_flattening& result)
  {
    const ABF_plus_plus_report& report = result.report;
    failed.push_back({report.strategy, report.status, report.message, report.iterations});
  }

  std::vector<double> target_angles(const Chart& chart, const ABF_plus_plus_options& options)
  {
    const Stage stage(options.visitor, Flattening_visitor::TARGET_ANGLES, seconds.targets);
    return ABF::target_angles(chart);
  }

  // `result` with its history
  Flattening<ABF_plus_plus_report> finish(const Direct_task& task, Direct_flattening result)
  {
    result.report.failed_strategies = std::move(failed);
    result.report.seconds = seconds;
    if(result.succeeded())
      report_seams(task.part, result.uv, result.report);
    return Flattening<ABF_plus_plus_report>(std::move(result));
  }
};

// The strategies of the direct method for one chart. A feasible disk has a valid map, which the last one finds unless
// the range of numbers is too small for it.
class Direct_strategies
{
  typedef ABF_plus_plus_report Report;

public:
  // `target_angles` are those of `task.chart`.
  Direct_strategies(const Direct_task& task, std::vector<double> target_angles, Attempts& attempts)
      : m_task(task), m_beta(std::move(target_angles)), m_attempts(attempts)
  {}

  // One attempt: Newton's method from angles `start`, near to the solution or not (Algorithm 18), then the layout
  Direct_flattening flatten(const ABF_plus_plus_options& options, std::vector<double> start,
                            Report::Strategy strategy,
                            const Constraint_vector& multipliers = Constraint_vector())
  {
    Direct_flattening result;
    Report& report = result.report = report_of<Report>(m_task.part);
    report.strategy = strategy;
    Angle_solution solution;
    {
      const Stage stage(options.visitor, Flattening_visitor::ANGLES, report.seconds.angles);
      solution = solve_angles(m_task.chart, m_beta, options, m_task.solvers, std::move(start), multipliers);
    }
    take_solution(solution, result);
    if(result.succeeded())
      result.uv = find_coordinates(m_task.chart, m_task.part, options, m_task.solvers, m_task.round,
                                   result.alpha, std::move(solution.scalar_solver), report);
    if(result.succeeded())
      certify_layout(m_task.part, options, result);
    m_attempts.seconds += report.seconds;
    return result;
  }

  const std::vector<double>& target_angles() const { return m_beta; }

  // Newton's method from the angles of an earlier map, changed as their targets have changed. (From the old angles
  // themselves, which meet the constraints, full steps would raise the merit function, as constraints are violated in
  // second order.)
  Direct_flattening from_last_angles(const Planar_angles& last)
  {
    std::vector<double> alpha(m_beta.size());
    for(std::size_t c = 0; c < alpha.size(); ++c)
      alpha[c] = last.alpha[c] * (m_beta[c] / last.beta[c]);
    const Eigen::Map<const Constraint_vector> multipliers(last.multipliers.data(),
                                                          static_cast<Eigen::Index>(last.multipliers.size()));
    return flatten(m_task.options, starting_angles(alpha), Report::FROM_LAST_ANGLES, multipliers);
  }

  // A high barrier keeps angles away from zero on the way. If all goes well it is lowered again, else the angles with
  // the high one are what there is.
  Direct_flattening raise_barrier()
  {
    ABF_plus_plus_options raised = m_task.options;
    raised.barrier = (std::max)(3., 30 * m_task.options.barrier);
    Direct_flattening result = flatten(raised, starting_angles(m_beta), Report::RAISED_BARRIER);
    if(result.succeeded()) {
      Direct_flattening lowered = flatten(m_task.options, std::move(result.alpha), Report::RAISED_BARRIER);
      if(lowered.succeeded() && lowered.report.converged)
        result = std::move(lowered);
    }
    return result;
  }

  // What is left when all else has failed: Newton's method from the angles of a progressive embedding, and else the
  // embedding itself
  Direct_flattening from_embedding()
  {
    std::optional<std::vector<Chart::Point_2>> embedding =
        progressive_embedding(m_task.chart, m_task.options);
    if(!embedding) {
      Direct_flattening result;
      result.report = report_of<Report>(m_task.part);
      result.report.strategy = Report::FROM_PROGRESSIVE_EMBEDDING;
      fail(result.report, Diagnosis::PRECISION_EXCEEDED, "no valid map was found in double precision");
      return result;
    }
    std::vector<double> alpha(m_beta.size());
    for(int c = 0; c < m_task.chart.number_of_corners(); ++c)
      alpha[c] = planar_angle(m_task.chart, *embedding, c);
    Direct_flattening result =
        flatten(m_task.options, starting_angles(alpha), Report::FROM_PROGRESSIVE_EMBEDDING);
    if(result.succeeded() && result.report.converged)
      return result;
    if(result.succeeded())
      fail(result.report, Diagnosis::NO_CONVERGENCE, "the angles did not converge");
    if(m_task.part.has_prescribed_angles()) // the embedding knows nothing of them
      return result;
    m_attempts.note_failure(result);
    embedding->resize(m_task.part.points.size());
    return take_embedding(*embedding);
  }

  // Adds to `result` where the next run is to start, if there is to be one.
  void keep_angles(Direct_flattening& result) const
  {
    if(m_task.options.warm_start && result.succeeded() && result.alpha.size() == m_beta.size())
      result.angles = std::make_shared<const Planar_angles>(
          Planar_angles{m_task.chart.vertex, m_task.chart.node, m_beta, result.alpha,
                        std::vector<double>(result.multipliers.begin(), result.multipliers.end())});
  }

private:
  // Near the limits of precision rounding by the scale to the surface's area is too much; a power of two rounds
  // nothing.
  Direct_flattening take_embedding(const std::vector<Chart::Point_2>& embedding) const
  {
    std::vector<Chart::Point_2> uv = embedding;
    scale_to_surface_area(m_task.part, uv);
    Direct_flattening result = certified_embedding(std::move(uv));
    if(result.succeeded())
      return result;
    const double factor = power_of_two(scale_to_surface(m_task.part, embedding));
    uv = embedding;
    for(Chart::Point_2& p : uv)
      p = CGAL::ORIGIN + (p - CGAL::ORIGIN) * factor;
    return certified_embedding(std::move(uv));
  }

  // `uv` if it is valid after rounding
  Direct_flattening certified_embedding(std::vector<Chart::Point_2> uv) const
  {
    Direct_flattening result;
    result.report = report_of<Report>(m_task.part);
    result.report.strategy = Report::PROGRESSIVE_EMBEDDING;
    m_task.round(uv);
    Certificate certificate = certify(m_task.part, uv);
    take_certificate(certificate, result.report);
    if(!certificate.is_valid())
      fail(result.report, Diagnosis::PRECISION_EXCEEDED,
           "the map is valid, but after rounding to the coordinates' number type it has " +
               describe_invalid(m_task.part, certificate));
    result.invalid = std::move(certificate.invalid);
    result.uv = std::move(uv);
    return result;
  }

  const Direct_task m_task;
  const std::vector<double> m_beta;
  Attempts& m_attempts;
};

// The map from the angles of an earlier one of the same triangles, if there is one and Newton's method converges
inline std::optional<Direct_flattening> warm_started(Direct_strategies& strategies, const Direct_task& task,
                                                     const Planar_angles* last, Attempts& attempts)
{
  if(last == nullptr || last->vertex != task.chart.vertex || last->node != task.chart.node ||
     static_cast<int>(last->multipliers.size()) != number_of_constraints(task.chart))
    return std::nullopt;
  Direct_flattening result = strategies.from_last_angles(*last);
  if(result.succeeded() && !result.report.converged)
    fail(result.report, Diagnosis::NO_CONVERGENCE, "the angles did not converge");
  if(result.succeeded())
    return result;
  attempts.note_failure(result);
  return std::nullopt;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_DIRECT_STRATEGIES_H
