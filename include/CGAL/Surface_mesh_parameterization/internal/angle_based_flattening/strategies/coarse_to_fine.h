// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Section 5 of the paper: coarsens a chart, has the coarse chart solved, refines and relaxes the map.
// `flatten_chart_hierarchically.h` adds holes, polishing and the certificate. The coarse solver is any function on
// charts.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_TO_FINE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_TO_FINE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/certify_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/angle_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/merged_weights.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/refine.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_level.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Flattens a chart by way of a coarser one.
class Coarse_to_fine
{
  typedef std::vector<Chart::Point_2> Layout;

public:
  Coarse_to_fine(Chart& chart, const Hierarchical_options& options, const Coarse_flattening& solve)
      : m_weights(chart), m_coarsening(chart), m_options(options), m_solve(solve),
        m_report(report_of<Hierarchical_report>(chart))
  {}

  Flattening<Hierarchical_report> run()
  {
    coarsen();
    m_is_solved = solve_coarse();
    const bool is_refined = m_report.status == Diagnosis::NOTHING_WRONG && refine();
    Flattening<Hierarchical_report> result;
    result.uv.reserve(m_uv.size());
    for(const Planar_point& p : m_uv)
      result.uv.emplace_back(p.x(), p.y());
    result.report = std::move(m_report);
    if(!is_refined && result.report.status == Diagnosis::NOTHING_WRONG)
      explain_failure(result.report);
    return result;
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

  void coarsen()
  {
    const Stage stage(m_options.visitor, Flattening_visitor::COARSEN, m_report.seconds.coarsen);
    m_coarsening.coarsen(coarse_size(), m_options.extreme_angle, m_options.visitor);
  }

  bool refine()
  {
    const Stage stage(m_options.visitor, Flattening_visitor::REFINE, m_report.seconds.refine);
    if(m_is_solved && undo_all_levels())
      return true;
    if(!m_options.fallbacks)
      return false;
    // A refinement that fails leaves a finer chart than before, which is made coarser in another way.
    bool is_refined = false;
    for(int attempt = 0; !is_refined && attempt < 3; ++attempt)
      is_refined = start_without_solver() && undo_all_levels();
    if(is_refined)
      m_report.note = "refinement started from one triangle: " +
                      (m_is_solved ? std::string("the map of the coarse chart could not be refined")
                                   : failure_of_coarse_charts(m_report));
    return is_refined;
  }

  static std::string failure_of_coarse_charts(const Hierarchical_report& report)
  {
    const std::size_t n = report.failed_coarse_charts.size();
    return "the coarse parameterizer gave no valid map of " +
           (n == 1 ? std::string("the coarse chart") : std::to_string(n) + " coarse charts") + "; " +
           (n == 1 ? "" : "of the last one, ") + report.failed_coarse_charts.back().message;
  }

  bool undo_all_levels()
  {
    Local_border border(m_coarsening, m_uv);
    Relaxation relaxation(m_coarsening, m_uv, border);
    Refinement refinement(m_coarsening, m_uv, relaxation);
    m_report.relaxed_angles = needs_angles();
    const std::optional<Angle_energy> angles =
        m_report.relaxed_angles ? std::optional(Angle_energy{m_options.barrier}) : std::nullopt;
    const bool is_refined = refinement.run(m_options.sweeps, angles, m_options.visitor);
    if(is_refined && m_options.angle_sweeps > 0)
      lower_energy(relaxation);
    m_report.kernel_insertions += refinement.kernel_insertions();
    m_report.moves += relaxation.moves();
    m_report.rejected_moves += relaxation.rejected_moves();
    return is_refined;
  }

  // Sweeps by the energy of angles take several times as long as those by MIPS. Large charts do without them, and
  // without the test.
  bool needs_angles() const
  {
    const int most_vertices = 100000;
    return m_report.start == Hierarchical_report::COARSE_PARAMETERIZER && m_options.sweeps > 0 &&
           m_report.vertices <= most_vertices && MIPS_changes_angles(m_coarsening, m_uv);
  }

  template <typename Relaxation>
  void lower_energy(Relaxation& relaxation)
  {
    Angle_descent descent(m_coarsening.mesh().chart(), m_options.barrier, m_uv);
    m_report.angle_sweeps = descent.run(relaxation, m_options.angle_sweeps, m_options.energy_tolerance);
    m_report.energy = descent.energy();
  }

  void explain_failure(Hierarchical_report& report) const
  {
    if(!m_options.fallbacks && !m_is_solved)
      fail(report, Diagnosis::COARSE_CHART_FAILED, failure_of_coarse_charts(report));
    else if(!m_options.fallbacks)
      fail(report, Diagnosis::PRECISION_EXCEEDED,
           "the map of the coarse chart could not be refined in double precision");
    else if(report.borders > 1)
      fail(report, Diagnosis::NO_CONVERGENCE,
           "no coarse chart could be flattened, and with several borders there is no other start");
    else
      fail(report, Diagnosis::PRECISION_EXCEEDED, "no valid map was found in double precision");
  }

  // Solves the coarse chart, or finer ones where that fails.
  bool solve_coarse()
  {
    const Stage stage(m_options.visitor, Flattening_visitor::COARSE_CHART, m_report.seconds.coarse_chart);
    for(int attempt = 0;; ++attempt) {
      Coarse_chart coarse = m_coarsening.coarse_chart();
      m_weights.apply(m_coarsening, coarse);
      m_report.levels = m_coarsening.number_of_levels();
      m_report.coarse_vertices = coarse.chart.number_of_vertices();
      m_report.coarse_triangles = coarse.chart.number_of_triangles();
      const Coarse_map map = m_solve(coarse.chart);
      m_report.status = map.status;
      if(map.status != Diagnosis::NOTHING_WRONG)
        return false;
      if(map.uv && is_valid_map(coarse.chart, *map.uv)) {
        take(coarse, *map.uv);
        m_report.note = map.note;
        return true;
      }
      note_failure(coarse.chart, map);
      if(attempt == m_options.max_retries || m_coarsening.number_of_levels() == 0)
        return false;
      const double finer = 1.5 * m_coarsening.number_of_vertices();
      while(m_coarsening.number_of_levels() > 0 && m_coarsening.number_of_vertices() < finer)
        m_coarsening.undo_level();
    }
  }

  void note_failure(const Chart& coarse, const Coarse_map& map)
  {
    Hierarchical_report::Failed_coarse_chart failure = {
        coarse.number_of_vertices(), coarse.number_of_triangles(), map.error, map.flipped_triangles,
        map.message.empty() ? "it has no map" : map.message};
    if(map.uv) {
      const Certificate certificate = certify_triangles(coarse, exact_points(*map.uv));
      failure.flipped_triangles = certificate.flipped_triangles;
      failure.message = "the map has " + describe_invalid(coarse, certificate);
    }
    m_report.failed_coarse_charts.push_back(std::move(failure));
  }

  // Collapses the chart to one triangle, which has a valid map without any solver. Inserting the vertices again makes a
  // progressive embedding.
  bool start_without_solver()
  {
    m_coarsening.coarsen(3, 0, m_options.visitor);
    const Coarse_chart coarse = m_coarsening.coarse_chart();
    m_report.start = Hierarchical_report::PROGRESSIVE_EMBEDDING;
    m_report.levels = m_coarsening.number_of_levels();
    m_report.coarse_vertices = coarse.chart.number_of_vertices();
    m_report.coarse_triangles = coarse.chart.number_of_triangles();
    if(coarse.chart.borders.size() != 1 || coarse.chart.number_of_interior_vertices > 0)
      return false;
    const std::vector<int>& border = coarse.chart.borders.front();
    Layout uv(coarse.chart.points.size());
    for(std::size_t i = 0; i < border.size(); ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(border.size());
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
    m_uv.resize(m_coarsening.mesh().chart().points.size());
    for(std::size_t v = 0; v < uv.size(); ++v)
      m_uv[coarse.vertices[v]] =
          Planar_point((uv[v].x() - box.xmin()) / size, (uv[v].y() - box.ymin()) / size);
  }

  Merged_weights m_weights;
  Coarsening m_coarsening;
  const Hierarchical_options& m_options;
  const Coarse_flattening& m_solve;
  Hierarchical_report m_report;
  bool m_is_solved = false;       // the coarse chart
  std::vector<Planar_point> m_uv; // of each vertex of the last stage of the coarsening
};

// Flattens a chart that `diagnose()` found flawless. Its connectivity changes meanwhile, and is restored if a valid map
// was found. The map is not certified yet.
inline Flattening<Hierarchical_report>
flatten_coarse_to_fine(Chart& chart, const Hierarchical_options& options, const Coarse_flattening& solve)
{
  return Coarse_to_fine(chart, options, solve).run();
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_STRATEGIES_COARSE_TO_FINE_H
