// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LADDER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LADDER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/flatten_from_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_hierarchically.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Simplifies a copy of the chart to one triangle, and puts all vertices back where their triangles are valid. The
// connectivity of the copy is lost if that fails.
inline bool find_valid_map(Chart chart, const ABF_plus_plus_options& options,
                           std::vector<Chart::Point_2>& valid)
{
  Hierarchical_options hierarchical;
  hierarchical.barrier = options.barrier;
  hierarchical.angle_sweeps = 10;
  hierarchical.max_retries = 0;
  hierarchical.visitor = options.visitor;
  const auto no_solver = [](const Chart&, std::vector<Chart::Point_2>&) { return false; };
  Hierarchical_report report;
  return flatten_hierarchically(chart, hierarchical, no_solver, valid, report);
}

// The ways to a valid map, one after the other until one leads there. A feasible chart with one border has a valid map,
// which the last way finds unless the range of numbers is too small for it.
class Ladder
{
  typedef ABF_plus_plus_report Report;
  typedef std::vector<Chart::Point_2> Layout;

public:
  Ladder(const Chart& chart, const ABF_plus_plus_options& options, const Linear_solvers& solvers,
         const Rounding& round, Report& report)
      : m_chart(chart), m_options(options), m_solvers(solvers), m_round(round), m_report(report)
  {}

  // Returns `false` with the reason in the report, and with the triangles in `flipped`.
  bool climb(Layout& uv, std::vector<int>& flipped)
  {
    Stopwatch stopwatch;
    visit_stage(m_options.visitor, Flattening_visitor::TARGET_ANGLES);
    m_beta = target_angles(m_chart);
    std::vector<double> alpha = starting_angles(m_beta);
    m_report.seconds.targets = stopwatch.lap();

    if(try_angles(Report::FROM_TARGET_ANGLES, m_options, alpha, uv, flipped))
      return true;
    if(!m_options.ladder || !is_worth_going_on())
      return false;
    return raise_barrier(uv, flipped) || (m_chart.borders.size() == 1 && start_from_valid_map(uv, flipped));
  }

private:
  // Where the solver itself fails, or is asked for something impossible, other angles do not help.
  bool is_worth_going_on() const
  {
    return m_report.diagnosis == Report::NO_CONVERGENCE || m_report.diagnosis == Report::FLIPPED_TRIANGLES;
  }

  bool try_angles(Report::Rung rung, const ABF_plus_plus_options& options, std::vector<double>& alpha,
                  Layout& uv, std::vector<int>& flipped)
  {
    enter(rung);
    return flatten_from_angles(m_chart, options, m_solvers, m_round, m_beta, alpha, uv, flipped, m_report);
  }

  // Notes that the rung before has failed, and forgets what it reported.
  void enter(Report::Rung rung)
  {
    Report fresh;
    fresh.seconds = m_report.seconds;
    fresh.failed_rungs = std::move(m_report.failed_rungs);
    fresh.vertices = m_report.vertices;
    fresh.triangles = m_report.triangles;
    fresh.borders = m_report.borders;
    if(m_report.status != OK)
      fresh.failed_rungs.push_back(
          {m_report.rung, m_report.diagnosis, m_report.message, m_report.iterations});
    fresh.rung = rung;
    m_report = std::move(fresh);
  }

  // A high barrier keeps angles away from zero on the way. If all goes well it is lowered again, else the angles with the
  // high one are what there is.
  bool raise_barrier(Layout& uv, std::vector<int>& flipped)
  {
    ABF_plus_plus_options raised = m_options;
    raised.barrier = (std::max)(3., 30 * m_options.barrier);
    std::vector<double> alpha = starting_angles(m_beta);
    if(!try_angles(Report::RAISED_BARRIER, raised, alpha, uv, flipped))
      return false;
    const Report high = m_report;
    Layout lowered;
    if(flatten_again(alpha, lowered, flipped) && m_report.converged) {
      uv.swap(lowered);
    } else {
      m_report = high;
      m_round(uv); // which remembers what is to be written
    }
    flipped.clear();
    return true;
  }

  bool start_from_valid_map(Layout& uv, std::vector<int>& flipped)
  {
    enter(Report::FROM_VALID_MAP);
    Layout valid;
    if(!find_valid_map(m_chart, m_options, valid)) {
      fail(m_report, ERROR_NO_1_TO_1_MAPPING, Report::PRECISION_EXCEEDED,
           "double precision does not hold any valid map that was tried");
      return false;
    }
    std::vector<double> alpha(m_beta.size());
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      alpha[c] = planar_angle(m_chart, valid, c);
    alpha = starting_angles(alpha);
    if(flatten_again(alpha, uv, flipped) && m_report.converged)
      return true;
    if(m_report.status == OK)
      fail(m_report, ERROR_NO_1_TO_1_MAPPING, Report::NO_CONVERGENCE, "the angles did not converge");
    return take_valid_map(valid, uv, flipped);
  }

  bool flatten_again(std::vector<double>& alpha, Layout& uv, std::vector<int>& flipped)
  {
    m_report.steps.clear();
    m_report.iterations = 0;
    m_report.converged = false;
    return flatten_from_angles(m_chart, m_options, m_solvers, m_round, m_beta, alpha, uv, flipped, m_report);
  }

  bool take_valid_map(const Layout& valid, Layout& uv, std::vector<int>& flipped)
  {
    enter(Report::VALID_MAP);
    uv = valid;
    scale_to_surface_area(m_chart, uv);
    if(is_valid(uv, flipped))
      return true;
    // Near the limits of precision even that rounding is too much; a power of two rounds nothing.
    const double factor = power_of_two(scale_to_surface(m_chart, valid));
    uv = valid;
    for(Chart::Point_2& p : uv)
      p = CGAL::ORIGIN + (p - CGAL::ORIGIN) * factor;
    if(is_valid(uv, flipped))
      return true;
    fail(m_report, ERROR_NO_1_TO_1_MAPPING, Report::PRECISION_EXCEEDED,
         "there is a valid map, but rounded to the coordinates' number type it has " +
             describe_invalid(m_chart, flipped, m_report));
    return false;
  }

  bool is_valid(Layout& uv, std::vector<int>& flipped)
  {
    m_round(uv);
    return inspect(m_chart, uv, m_report, flipped);
  }

  const Chart& m_chart;
  const ABF_plus_plus_options& m_options;
  const Linear_solvers& m_solvers;
  const Rounding& m_round;
  Report& m_report;
  std::vector<double> m_beta;
};

CGAL_ANGLE_BASED_FLATTENING_INLINE bool flatten_chart(const Chart& chart,
                                                      const ABF_plus_plus_options& options,
                                                      const Linear_solvers& solvers, const Rounding& round,
                                                      std::vector<Chart::Point_2>& uv,
                                                      std::vector<int>& flipped, ABF_plus_plus_report& report)
{
  return Ladder(chart, options, solvers, round, report).climb(uv, flipped);
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_LADDER_H
