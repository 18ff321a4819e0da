// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The last stage of the injective method, on the whole chart: sweeps that lower the energy of angles (Eq. 1), Newton
// steps if the map is to be polished, and triangles that were crushed are widened. `flatten_injectively.h` ends with
// it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_POLISH_MAP_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_POLISH_MAP_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/distortion/triangle_differential.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/injective_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/objectives.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/angle_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// From this number of vertices on, time is linear.
inline constexpr int large_chart = 100000;

// Charts of up to this size are relaxed as a whole, by Newton's method, and larger ones vertex by vertex. Newton's
// method may take about a third of the time.
inline int most_newton_vertices(const Chart& chart)
{
  const int n = chart.number_of_vertices(), most = 20000;
  return n <= large_chart ? most : (std::min)((std::max)(n / 20, most / 2), most);
}

// When the energy of angles has converged
inline Descent_limits polish_limits(int steps, bool is_finest)
{
  return {1e-2, steps, is_finest ? 5e-2 : 0};
}

// Descends, and writes to a report what happened.
class Reported_descents
{
public:
  Reported_descents(const Hierarchical_options& options, const Linear_solvers& solvers,
                    Hierarchical_report& report)
      : m_options(options), m_solvers(solvers), m_report(report)
  {}

  bool succeeded() const { return m_report.status == Diagnosis::NOTHING_WRONG; }
  int steps() const { return m_steps; } // of the last descent

  // Returns whether the descent has converged.
  template <typename Objective>
  bool run(const Chart& chart, const Objective& objective, const Descent_limits& limits,
           std::vector<Planar_point>& uv)
  {
    Injective_descent<Objective> descent(chart, objective, m_options.clearance, m_solvers);
    if(succeeded() && !descent.run(uv, limits))
      fail(m_report, Diagnosis::LINEAR_SYSTEM_FAILED,
           "the linear system of a Newton step with " + std::to_string(chart.number_of_vertices()) +
               " vertices could not be solved");
    m_report.border_rejections += descent.rejections();
    m_steps = descent.steps();
    return descent.has_converged();
  }

private:
  const Hierarchical_options& m_options;
  const Linear_solvers& m_solvers;
  Hierarchical_report& m_report;
  int m_steps = 0;
};

inline std::vector<Chart::Point_2> chart_points(const std::vector<Planar_point>& uv)
{
  std::vector<Chart::Point_2> result;
  for(const Planar_point& p : uv)
    result.emplace_back(p.x(), p.y());
  return result;
}

// The vertices of crushed triangles. If areas hardly count, also those of triangles that have shrunk with them.
inline std::vector<int> vertices_to_widen(const Chart& chart, const std::vector<Chart::Point_2>& uv,
                                          bool is_isometric)
{
  constexpr double most_shrinking = 100; // relative to the mean
  const Total_areas total = total_areas(chart, uv);
  const double bound = is_isometric ? (std::numeric_limits<double>::infinity)()
                                    : most_shrinking * std::sqrt(total.surface / total.plane);
  std::vector<int> result;
  for(int t = 0; t < chart.number_of_triangles(); ++t)
    if(is_crushed(chart, uv, t) ||
       (!is_needle(chart, t) && Triangle_differential(chart, uv, t).largest_stretch() > bound))
      result.insert(result.end(), &chart.vertex[3 * t], &chart.vertex[3 * t] + 3);
  return result;
}

// Crushed triangles are at a minimum of the energy by which the map was relaxed, so another energy widens them. If
// areas count, small triangles have little energy, and large ones may crush them; energies of angles do not depend on
// sizes. If areas hardly count, a vertex may shrink its whole star; the isometric energy spreads it again.
//
// `relaxation` moves the vertices of `uv`.
template <typename Relaxation>
void widen_crushed_triangles(const Chart& chart, const std::vector<Planar_point>& uv, bool is_isometric,
                             double barrier, Relaxation& relaxation)
{
  const int most_rounds = 20;
  if(!has_crushed_triangles(chart, chart_points(uv)))
    return;
  const std::vector<double> beta = is_isometric ? target_angles(chart) : std::vector<double>();
  for(int round = 0; round < most_rounds; ++round) {
    Deadline::ask();
    const std::vector<int> vertices = vertices_to_widen(chart, chart_points(uv), is_isometric);
    if(vertices.empty())
      return;
    if(is_isometric)
      relaxation.move(Angle_star(beta, Angle_energy{barrier}), vertices);
    else
      relaxation.move(Area_star(1), vertices);
  }
}

// Improves the map `uv` of a whole chart, whose vertices `relaxation` moves.
template <typename Relaxation>
class Map_polish
{
public:
  Map_polish(const Chart& chart, const Hierarchical_options& options, Reported_descents& descents,
             std::vector<Planar_point>& uv, Relaxation& relaxation, Hierarchical_report& report)
      : m_chart(chart), m_options(options), m_descents(descents), m_uv(uv), m_relaxation(relaxation),
        m_report(report)
  {}

  void run()
  {
    lower_energy();
    if(m_options.polish && !m_report.polished)
      polish();
    const Stage stage(m_options.visitor, Flattening_visitor::REFINE, m_report.seconds.refine);
    widen_crushed_triangles(m_chart, m_uv, is_isometric(m_options), m_options.barrier, m_relaxation);
  }

private:
  // Sweeps that the option `angle_sweeps` does not ask for: most where they take the place of Newton's method
  int usual_angle_sweeps() const
  {
    const int n = m_chart.number_of_vertices();
    if(m_report.polished)
      return 1;
    return n > large_chart ? 3 : n > most_newton_vertices(m_chart) || m_options.polish ? 4 : 7;
  }

  // Successive over-relaxation (Young 1954). The first sweep and the last one are plain, for errors that change from
  // vertex to vertex.
  static Angle_star over_relaxed(Angle_star star, bool is_smooth)
  {
    star.over_relaxation = is_smooth ? 1.7 : 1;
    return star;
  }

  void lower_energy()
  {
    const Stage stage(m_options.visitor, Flattening_visitor::REFINE, m_report.seconds.refine);
    if(m_options.angle_sweeps == 0 && is_isometric(m_options) && !m_report.polished)
      return;
    Angle_descent descent(m_chart, m_options.barrier, m_uv);
    if(m_options.angle_sweeps > 0) {
      m_report.angle_sweeps = descent.run(m_relaxation, m_options.angle_sweeps, m_options.energy_tolerance);
    } else {
      m_report.angle_sweeps = usual_angle_sweeps();
      for(int i = 1; i < m_report.angle_sweeps; ++i)
        m_relaxation.sweep(over_relaxed(descent.star(), i > 1));
      descent.run(m_relaxation, 1, 0);
    }
    m_report.energy = descent.energy();
  }

  // Newton steps towards the least energy of the direct method, each followed by a sweep that mends slivers
  void polish()
  {
    const std::vector<double> beta = target_angles(m_chart);
    const Angle_objective objective(m_chart, beta, Angle_energy{m_options.barrier});
    Angle_descent sweeps(m_chart, m_options.barrier, m_uv);
    polish_by([&] {
      m_report.polished = m_descents.run(m_chart, objective, polish_limits(1, true), m_uv);
      sweeps.run(m_relaxation, 1, 0);
    });
    if(m_report.polishing_timed_out)
      sweeps.run(m_relaxation, 0, 0); // finds the energy
    m_report.energy = sweeps.energy();
  }

  // A step for which there is no time left is undone.
  template <typename Step>
  void polish_by(const Step& step)
  {
    const int most_steps = 10;
    const Deadline deadline(m_options.polish_options.time_limit);
    while(m_descents.succeeded() && m_report.polish_iterations < most_steps && !m_report.polished &&
          !m_report.polishing_timed_out) {
      const std::vector<Planar_point> before = m_uv;
      m_report.polishing_timed_out = !deadline.allows([&] {
        const Stage stage(m_options.visitor, Flattening_visitor::POLISH, m_report.seconds.polish);
        step();
      });
      if(m_report.polishing_timed_out) {
        m_uv = before;
        m_report.polished = false;
      } else {
        ++m_report.polish_iterations;
      }
    }
  }

  const Chart& m_chart;
  const Hierarchical_options& m_options;
  Reported_descents& m_descents;
  std::vector<Planar_point>& m_uv;
  Relaxation& m_relaxation;
  Hierarchical_report& m_report;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_POLISH_MAP_H
