// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The injective method: coarsening, Tutte's map, descent, refinement and polishing, with a map that is injective at
// every step. The option `injective` gets here, by way of `flatten_chart_hierarchically.h`. The paper instead mends
// overlaps after the map is made.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_FLATTEN_INJECTIVELY_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_FLATTEN_INJECTIVELY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/Flattening_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/injective_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/objectives.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/polish_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/tutte_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/merged_weights.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/refine.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_level.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Flattens a disk from coarse to fine, starting from Tutte's map of a coarse chart. The map is always injective.
class Injective_flattening
{
public:
  Injective_flattening(Chart& chart, const Hierarchical_options& options, const Linear_solvers& solvers,
                       const std::vector<Chart::Point_2>* start)
      : m_weights(chart), m_coarsening(chart), m_keeper(options.clearance), m_options(options),
        m_solvers(solvers), m_start(start), m_most_newton_vertices(most_newton_vertices(chart)),
        m_report(report_of<Hierarchical_report>(chart)), m_descents(options, solvers, m_report),
        m_relaxation(m_coarsening, m_uv, m_keeper)
  {}

  Flattening<Hierarchical_report> run()
  {
    bool is_refined = false;
    for(int size = 300; !is_refined && succeeded() && size > 2; size /= 4) {
      coarsen(size);
      is_refined = start() && refine();
    }
    if(is_refined)
      finish();
    else if(succeeded())
      fail(m_report, Diagnosis::PRECISION_EXCEEDED,
           "no injective map was found in double precision; a larger area weight may help");
    Flattening<Hierarchical_report> result;
    result.uv = chart_points(m_uv);
    result.report = std::move(m_report);
    return result;
  }

private:
  // Of descents on the coarse chart, before areas have their weight, and then
  static constexpr Descent_limits first_limits = {1e-2, 200}, coarse_limits = {1e-3, 200};

  bool succeeded() const { return m_descents.succeeded(); }
  bool is_isometric() const { return ABF::is_isometric(m_options); }

  void coarsen(int size)
  {
    const Stage stage(m_options.visitor, Flattening_visitor::COARSEN, m_report.seconds.coarsen);
    m_coarsening.coarsen(size, size > 100 ? m_options.extreme_angle : 0, m_options.visitor);
  }

  // Finds an injective map of the coarse chart.
  bool start()
  {
    const Stage stage(m_options.visitor, Flattening_visitor::COARSE_CHART, m_report.seconds.coarse_chart);
    const Coarse_chart coarse = coarse_chart();
    m_report.levels = m_coarsening.number_of_levels();
    m_report.coarse_vertices = coarse.chart.number_of_vertices();
    m_report.coarse_triangles = coarse.chart.number_of_triangles();
    std::optional<std::vector<Planar_point>> uv;
    if(m_start != nullptr)
      uv = map_of_coarse_chart(*m_start, coarse);
    const bool is_given = uv && is_injective_map(coarse.chart, *uv);
    if(!is_given)
      uv = tutte_map(coarse.chart);
    if(!uv)
      return false;
    // A large area weight at first spreads branches before they lock. Isometric maps begin with a smaller one than they
    // want, as their energy is far from convex.
    const std::vector<double> area_weights =
        is_isometric() ? std::vector<double>{0.2, 0.4, 0.7} : std::vector<double>{0.5};
    for(double area_weight : is_given ? std::vector<double>() : area_weights)
      m_descents.run(coarse.chart, Area_objective(coarse.chart, area_weight), first_limits, *uv);
    m_descents.run(coarse.chart, Area_objective(coarse.chart, m_options.area_weight), coarse_limits, *uv);
    m_uv.resize(m_coarsening.mesh().chart().points.size());
    put_back(coarse, *uv);
    return succeeded();
  }

  std::optional<std::vector<Planar_point>> tutte_map(const Chart& coarse)
  {
    m_report.start = Hierarchical_report::TUTTE_MAP;
    std::optional<std::vector<Planar_point>> uv = Tutte_map(coarse).run(m_solvers);
    if(!uv)
      fail(m_report, Diagnosis::LINEAR_SYSTEM_FAILED,
           "the linear system of Tutte's map of the coarse chart could not be solved");
    return uv && is_injective_map(coarse, *uv) ? uv : std::nullopt;
  }

  Coarse_chart coarse_chart() const
  {
    Coarse_chart coarse = m_coarsening.coarse_chart();
    m_weights.apply(m_coarsening, coarse);
    return coarse;
  }

  void put_back(const Coarse_chart& coarse, const std::vector<Planar_point>& uv)
  {
    for(std::size_t v = 0; v < uv.size(); ++v)
      m_uv[coarse.vertices[v]] = uv[v];
  }

  // Relaxes the whole current chart. A map to be polished comes near to the least energy of the angles on the last of
  // these levels, while that is cheap. On the finest one, it is polished if that converges.
  void descend_on_level()
  {
    const Coarse_chart coarse = coarse_chart();
    std::vector<Planar_point> uv;
    for(int v : coarse.vertices)
      uv.push_back(m_uv[v]);
    if(m_options.polish && 2 * coarse.chart.number_of_vertices() > m_most_newton_vertices) {
      const bool is_finest = m_coarsening.number_of_levels() == 0;
      const std::vector<double> beta = target_angles(coarse.chart);
      const Angle_objective objective(coarse.chart, beta, Angle_energy{m_options.barrier});
      const bool has_converged = m_descents.run(coarse.chart, objective, polish_limits(5, is_finest), uv);
      if(is_finest) {
        m_report.polished = has_converged;
        m_report.polish_iterations = m_descents.steps();
      }
    } else {
      const Descent_limits limits = {is_isometric() ? 1e-2 : 5e-2, 10};
      m_descents.run(coarse.chart, Area_objective(coarse.chart, m_options.area_weight), limits, uv);
    }
    put_back(coarse, uv);
  }

  // Whether the current level is relaxed as a whole. The finest one is only where that is worth more than sweeps on the
  // energy of angles, which take less time.
  bool needs_newton() const
  {
    return m_coarsening.number_of_vertices() <= m_most_newton_vertices &&
           (m_coarsening.number_of_levels() > 0 || is_isometric() || m_options.polish);
  }

  // Undoes all levels. Returns `false` if a vertex has no valid position in its star.
  bool refine()
  {
    const Stage stage(m_options.visitor, Flattening_visitor::REFINE, m_report.seconds.refine);
    Refinement refinement(m_coarsening, m_uv, m_relaxation);
    int size_of_last_descent = m_coarsening.number_of_vertices();
    bool is_refined = true;
    while(is_refined && m_coarsening.number_of_levels() > 0) {
      is_refined = refinement.undo_level(m_options.visitor);
      const int size = m_coarsening.number_of_vertices();
      // Sweeps mend slivers, at which Newton's method could only take short steps.
      if(is_refined)
        relax();
      if(is_refined && needs_newton() &&
         (size > 1.7 * size_of_last_descent || m_coarsening.number_of_levels() == 0)) {
        descend_on_level();
        size_of_last_descent = size;
        is_refined = succeeded();
      }
    }
    m_report.kernel_insertions += refinement.kernel_insertions();
    return is_refined;
  }

  // On large charts, areas hardly matter for a single vertex, but take time.
  void relax()
  {
    const bool is_large = m_coarsening.number_of_vertices() > m_most_newton_vertices;
    const bool is_fine = m_coarsening.number_of_levels() < 3;
    const int sweeps =
        !is_large || (is_fine && !is_isometric()) ? (std::min)(m_options.sweeps, 1) : m_options.sweeps;
    if(is_large && !is_isometric())
      return relax_level(m_coarsening, m_relaxation, sweeps);
    for(int i = 0; i < sweeps; ++i)
      m_relaxation.sweep(Area_star(m_options.area_weight));
  }

  void finish()
  {
    Map_polish(m_coarsening.mesh().chart(), m_options, m_descents, m_uv, m_relaxation, m_report).run();
    m_relaxation.take_border();
    const Border_contact contact = m_keeper.contact();
    m_report.contact = contact.share;
    m_report.least_clearance = contact.least_clearance;
    m_report.border_rejections += m_keeper.rejections();
    m_report.moves = m_relaxation.moves();
    m_report.rejected_moves = m_relaxation.rejected_moves();
  }

  Merged_weights m_weights;
  Coarsening m_coarsening;
  Border_keeper m_keeper;
  const Hierarchical_options& m_options;
  const Linear_solvers& m_solvers;
  const std::vector<Chart::Point_2>* m_start; // an injective map, or null
  int m_most_newton_vertices;
  Hierarchical_report m_report;
  Reported_descents m_descents;
  std::vector<Planar_point> m_uv; // of each vertex of the last stage of the coarsening
  Relaxation<Border_keeper> m_relaxation;
};

// Flattens a disk that `diagnose()` found flawless, starting from an injective map if one is given. The connectivity of
// the disk changes meanwhile, and is restored if a map was found. The map is not certified yet.
inline Flattening<Hierarchical_report> flatten_injectively(Chart& chart, const Hierarchical_options& options,
                                                           const Linear_solvers& solvers,
                                                           const std::vector<Chart::Point_2>* start)
{
  return Injective_flattening(chart, options, solvers, start).run();
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_FLATTEN_INJECTIVELY_H
