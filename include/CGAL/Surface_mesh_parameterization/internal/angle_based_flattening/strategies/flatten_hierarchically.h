// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_FLATTEN_HIERARCHICALLY_H
#define CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_FLATTEN_HIERARCHICALLY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/flatten_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/stopwatch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarse_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/refine.h>

#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Flattens a chart by way of a coarser one.
class Hierarchical_flattening
{
  typedef std::vector<Chart::Point_2> Layout;

public:
  Hierarchical_flattening(Chart& chart, const Hierarchical_options& options, const Coarse_flattening& solve,
                          Hierarchical_report& report)
      : m_coarsening(chart), m_options(options), m_solve(solve), m_report(report),
        m_uv(chart.points.size(), Planar_point(0, 0))
  {}

  // Returns `false` if no valid map was found.
  bool run(Layout& uv)
  {
    Stopwatch stopwatch;
    visit_stage(m_options.visitor, Flattening_visitor::COARSEN);
    m_coarsening.coarsen(coarse_size(), m_options.extreme_angle, m_options.visitor);
    m_report.seconds.coarsen = stopwatch.lap();
    visit_stage(m_options.visitor, Flattening_visitor::COARSE_CHART);
    const bool solved = solve_coarse();
    m_report.seconds.solve = stopwatch.lap();
    visit_stage(m_options.visitor, Flattening_visitor::REFINE);
    bool refined = solved && refine();
    // A refinement that fails leaves a finer chart behind than the one before, that is made coarser in another way.
    for(int attempt = 0; !refined && attempt < 3; ++attempt)
      refined = start_without_solver() && refine();
    for(const Planar_point& p : m_uv)
      uv.emplace_back(p.x(), p.y());
    m_report.seconds.refine = stopwatch.lap();
    return refined;
  }

private:
  int coarse_size() const
  {
    // A disk has about half as many vertices as triangles.
    const double size = m_options.coarse_triangles > 0
                            ? m_options.coarse_triangles / 2.
                            : (1 - m_options.simplification_rate) * m_coarsening.number_of_vertices();
    return (std::max)(static_cast<int>(size), 100);
  }

  bool refine()
  {
    Refinement refinement(m_coarsening, m_uv, m_report);
    if(!refinement.run(m_options.sweeps, m_options.visitor))
      return false;
    refinement.lower_angle_energy(m_options.angle_sweeps, m_options.barrier);
    return true;
  }

  // Solves the coarse chart, or finer ones where that fails.
  bool solve_coarse()
  {
    for(int attempt = 0;; ++attempt) {
      const Coarse_chart coarse(m_coarsening.mesh(), m_coarsening.alive());
      m_report.levels = m_coarsening.number_of_levels();
      m_report.coarse_vertices = coarse.chart.number_of_vertices();
      m_report.coarse_triangles = coarse.chart.number_of_triangles();
      Layout uv;
      if(m_solve(coarse.chart, uv) && flipped_triangles(coarse.chart, uv).empty()) {
        take(coarse, uv);
        return true;
      }
      if(attempt == m_options.max_retries || m_coarsening.number_of_levels() == 0)
        return false;
      ++m_report.retries;
      const double finer = 1.5 * m_coarsening.number_of_vertices();
      while(m_coarsening.number_of_levels() > 0 && m_coarsening.number_of_vertices() < finer)
        m_coarsening.undo_level();
    }
  }

  // Collapses all that is there to one triangle, which has a valid map without any solver.
  bool start_without_solver()
  {
    m_coarsening.coarsen(3, 0, m_options.visitor);
    const Coarse_chart coarse(m_coarsening.mesh(), m_coarsening.alive());
    m_report.start = Hierarchical_report::WITHOUT_SOLVER;
    m_report.levels = m_coarsening.number_of_levels();
    m_report.coarse_vertices = coarse.chart.number_of_vertices();
    m_report.coarse_triangles = coarse.chart.number_of_triangles();
    if(coarse.chart.borders.size() != 1 || coarse.chart.number_of_interior_vertices > 0)
      return false;
    const std::vector<int>& border = coarse.chart.borders.front();
    Layout uv(coarse.chart.points.size());
    for(std::size_t i = 0; i < border.size(); ++i) {
      const double angle = 2 * pi * i / border.size();
      uv[coarse.chart.edge_source(border[i])] = Chart::Point_2(std::cos(angle), std::sin(angle));
    }
    take(coarse, uv);
    return true;
  }

  // Coordinates are scaled so that their box has the size of one.
  void take(const Coarse_chart& coarse, const Layout& uv)
  {
    const auto box = CGAL::bounding_box(uv.begin(), uv.end());
    const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    for(std::size_t v = 0; v < uv.size(); ++v)
      m_uv[coarse.vertices[v]] =
          Planar_point((uv[v].x() - box.xmin()) / size, (uv[v].y() - box.ymin()) / size);
  }

  Coarsening m_coarsening;
  const Hierarchical_options& m_options;
  const Coarse_flattening& m_solve;
  Hierarchical_report& m_report;
  std::vector<Planar_point> m_uv; // of each vertex that is there
};

// Flattens a chart that `diagnose()` found flawless. Its connectivity is changed on the way, and is as before if a valid
// map was found. Returns `false` if none was.
inline bool flatten_hierarchically(Chart& chart, const Hierarchical_options& options,
                                   const Coarse_flattening& solve, std::vector<Chart::Point_2>& uv,
                                   Hierarchical_report& report)
{
  return Hierarchical_flattening(chart, options, solve, report).run(uv);
}

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_FLATTEN_HIERARCHICALLY_H
