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
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/objectives.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/border_barrier.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/injective_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/tutte_map.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/widen_crushed_triangles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/angle_descent.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/merged_weights.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/refine.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_level.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
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
        m_report(report_of<Hierarchical_report>(chart)), m_relaxation(m_coarsening, m_uv, m_keeper)
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
  // From this number of vertices on, time is linear.
  static constexpr int large_chart = 100000;

  // When the energy of angles has converged (`Descent_limits`)
  static constexpr double polish_tolerance = 1e-2, full_step_tolerance = 5e-2;

  // Charts of up to this size are relaxed as a whole, by Newton's method, and larger ones vertex by vertex. Newton's
  // method may take about a third of the time.
  static int most_newton_vertices(const Chart& chart)
  {
    const int n = chart.number_of_vertices(), most = 20000;
    return n <= large_chart ? most : (std::min)((std::max)(n / 20, most / 2), most);
  }

  bool succeeded() const { return m_report.status == Diagnosis::NOTHING_WRONG; }

  // From this weight on, areas count as much as angles, and sweeps on the energy of angles alone would undo this.
  bool is_isometric() const { return m_options.area_weight > 0.1; }

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
    std::optional<std::vector<Planar_point>> uv = given_map(coarse);
    const bool is_given = uv && is_injective(coarse.chart, *uv);
    if(!is_given)
      uv = tutte_map(coarse.chart);
    if(!uv)
      return false;
    // A large area weight at first spreads branches before they lock. Isometric maps begin with a smaller one than they
    // want, as their energy is far from convex.
    const std::vector<double> area_weights =
        is_isometric() ? std::vector<double>{0.2, 0.4, 0.7} : std::vector<double>{0.5};
    for(double area_weight : is_given ? std::vector<double>() : area_weights)
      descend(coarse.chart, area_weight, {1e-2, 200}, *uv);
    descend(coarse.chart, m_options.area_weight, {1e-3, 200}, *uv);
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
    return uv && is_injective(coarse, *uv) ? uv : std::nullopt;
  }

  // The map to start from at the vertices of the coarse chart, as large as its surface; nothing if none is given
  std::optional<std::vector<Planar_point>> given_map(const Coarse_chart& coarse) const
  {
    if(m_start == nullptr)
      return std::nullopt;
    std::vector<Planar_point> uv;
    for(int v : coarse.vertices)
      uv.emplace_back((*m_start)[v].x(), (*m_start)[v].y());
    double surface = 0, plane = 0;
    for(int t = 0; t < coarse.chart.number_of_triangles(); ++t) {
      const int* v = &coarse.chart.vertex[3 * t];
      surface += surface_area(coarse.chart, t);
      plane += cross(uv[v[1]] - uv[v[0]], uv[v[2]] - uv[v[0]]) / 2;
    }
    if(!(plane > 0))
      return std::nullopt;
    for(Planar_point& p : uv)
      p *= std::sqrt(surface / plane);
    return uv;
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

  static bool is_injective(const Chart& chart, const std::vector<Planar_point>& uv)
  {
    std::vector<Exact_point_2> points;
    for(const Planar_point& p : uv)
      points.emplace_back(p.x(), p.y());
    return flipped_triangles(chart.vertex, points).empty() && is_border_simple(chart, points);
  }

  void descend(const Chart& chart, double area_weight, const Descent_limits& limits,
               std::vector<Planar_point>& uv)
  {
    descend(chart, Area_objective(chart, area_weight), limits, uv);
  }

  // Returns whether the descent has converged.
  template <typename Objective>
  bool descend(const Chart& chart, const Objective& objective, const Descent_limits& limits,
               std::vector<Planar_point>& uv)
  {
    Injective_descent<Objective> descent(chart, objective, m_options.clearance, m_solvers);
    if(succeeded() && !descent.run(uv, limits))
      fail(m_report, Diagnosis::LINEAR_SYSTEM_FAILED,
           "the linear system of a Newton step with " + std::to_string(chart.number_of_vertices()) +
               " vertices could not be solved");
    m_report.border_rejections += descent.rejections();
    m_descent_steps = descent.steps();
    return descent.has_converged();
  }

  // Relaxes the whole current chart. A map to be polished comes near to the least energy of the angles on the last of
  // these levels, while that is cheap. On the finest one, it is polished if that converges.
  void descend_on_level()
  {
    const Coarse_chart coarse = coarse_chart();
    std::vector<Planar_point> uv;
    for(int v : coarse.vertices)
      uv.push_back(m_uv[v]);
    const bool is_finest = m_coarsening.number_of_levels() == 0;
    if(m_options.polish && 2 * coarse.chart.number_of_vertices() > m_most_newton_vertices) {
      const std::vector<double> beta = target_angles(coarse.chart);
      const bool has_converged =
          descend(coarse.chart, Angle_objective(coarse.chart, beta, Angle_energy{m_options.barrier}),
                  {polish_tolerance, 5, is_finest ? full_step_tolerance : 0}, uv);
      if(is_finest) {
        m_report.polished = has_converged;
        m_report.polish_iterations = m_descent_steps;
      }
    } else {
      descend(coarse.chart, m_options.area_weight, {is_isometric() ? 1e-2 : 5e-2, 10}, uv);
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
    lower_energy();
    if(m_options.polish && !m_report.polished)
      polish();
    {
      const Stage stage(m_options.visitor, Flattening_visitor::REFINE, m_report.seconds.refine);
      widen_crushed_triangles(m_coarsening.mesh().chart(), m_uv, is_isometric(), m_options.barrier,
                              m_relaxation);
    }
    m_relaxation.take_border();
    const Border_contact contact = m_keeper.contact();
    m_report.contact = contact.share;
    m_report.least_clearance = contact.least_clearance;
    m_report.border_rejections += m_keeper.rejections();
    m_report.moves = m_relaxation.moves();
    m_report.rejected_moves = m_relaxation.rejected_moves();
  }

  // Sweeps that the option `angle_sweeps` does not ask for: most where they take the place of Newton's method
  int usual_angle_sweeps() const
  {
    const int n = m_coarsening.number_of_vertices();
    if(m_report.polished)
      return 1;
    return n > large_chart ? 3 : n > m_most_newton_vertices || m_options.polish ? 4 : 7;
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
    if(m_options.angle_sweeps == 0 && is_isometric() && !m_report.polished)
      return;
    Angle_descent descent(m_coarsening.mesh().chart(), m_options.barrier, m_uv);
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
    const Chart& chart = m_coarsening.mesh().chart();
    const std::vector<double> beta = target_angles(chart);
    const Angle_objective objective(chart, beta, Angle_energy{m_options.barrier});
    Angle_descent sweeps(chart, m_options.barrier, m_uv);
    polish_by([&] {
      m_report.polished = descend(chart, objective, {polish_tolerance, 1, full_step_tolerance}, m_uv);
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
    while(succeeded() && m_report.polish_iterations < most_steps && !m_report.polished &&
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

  Merged_weights m_weights;
  Coarsening m_coarsening;
  Border_keeper m_keeper;
  const Hierarchical_options& m_options;
  const Linear_solvers& m_solvers;
  const std::vector<Chart::Point_2>* m_start; // an injective map, or null
  int m_most_newton_vertices;
  Hierarchical_report m_report;
  int m_descent_steps = 0;        // of the last descent
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
