// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef ABF_BENCHMARK_SEQUENTIAL_HIERARCHY_H
#define ABF_BENCHMARK_SEQUENTIAL_HIERARCHY_H

// The hierarchical method as Section 5 of the paper describes it, as a baseline: vertices are removed one at a time
// from a priority queue, and put back one at a time in reverse order. Taken from the library: the chart and its
// collapses (`Edge_collapses`), the cost and the vetoes of a collapse (`Collapse_cost`: volume-based error with a
// term for the shape, the limit of 2.5 degrees, border vertices along the border only), the star of a vertex with
// its flip check (`Planar_star`), and the places that harmonic weights or Eq. 22 and the kernel give to a vertex.

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_report.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/read_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarse_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/collapse_cost.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/insert_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/coarse_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/run_parameterizer.h>

#include <boost/heap/d_ary_heap.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace ABF_benchmark {

namespace SMP = CGAL::Surface_mesh_parameterization;
namespace abf = CGAL::Surface_mesh_parameterization::internal::ABF;

inline void neighbours(const abf::Edge_collapses& mesh, const int v, std::vector<int>& ring)
{
  const abf::Chart& chart = mesh.chart();
  ring.clear();
  mesh.for_each_corner(v, [&](const int c) {
    ring.push_back(chart.vertex[abf::previous_corner(c)]);
    if(chart.rotate(c) < 0)
      ring.push_back(chart.vertex[abf::next_corner(c)]);
  });
}

// Removes the vertex whose collapse is the cheapest of all, again and again.
class Sequential_coarsening
{
public:
  Sequential_coarsening(abf::Edge_collapses& mesh, const double extreme_angle)
      : m_mesh(mesh), m_cost(mesh, extreme_angle), m_handles(mesh.chart().points.size())
  {
    for(int v = 0; v < m_mesh.chart().number_of_vertices(); ++v) {
      m_handles[v] = m_queue.push({m_cost.best(v), v});
    }
  }

  // Goes on until `target` vertices are left, or no collapse is allowed any more.
  void coarsen(const int target)
  {
    int vertices = m_mesh.chart().number_of_vertices();
    while(vertices > target && m_queue.top().candidate) {
      const Entry next = m_queue.top();
      // What is farther than its star can forbid a collapse, too.
      if(m_cost.is_still_allowed(next.vertex, next.candidate.record)) {
        collapse(next);
        --vertices;
      } else {
        rank(next.vertex);
      }
    }
  }

private:
  struct Entry
  {
    abf::Collapse_candidate candidate;
    int vertex;

    // The top of the queue is the largest entry.
    bool operator<(const Entry& other) const
    {
      return candidate.cost > other.candidate.cost ||
             (candidate.cost == other.candidate.cost && vertex > other.vertex);
    }
  };

  typedef boost::heap::d_ary_heap<Entry, boost::heap::arity<4>, boost::heap::mutable_<true>> Queue;

  void rank(const int v) { m_queue.update(m_handles[v], {m_cost.best(v), v}); }

  void collapse(const Entry& entry)
  {
    neighbours(m_mesh, entry.vertex, m_ring);
    m_queue.erase(m_handles[entry.vertex]);
    m_mesh.collapse(entry.candidate.record);
    for(const int v : m_ring)
      rank(v);
  }

  abf::Edge_collapses& m_mesh;
  abf::Collapse_cost m_cost;
  Queue m_queue;
  std::vector<Queue::handle_type> m_handles; // of each vertex
  std::vector<int> m_ring;
};

// Puts the vertices back one by one (Section 5.2).
class Sequential_refinement
{
public:
  Sequential_refinement(abf::Edge_collapses& mesh, std::vector<abf::Planar_point>& uv,
                        SMP::Hierarchical_report& report)
      : m_mesh(mesh), m_uv(uv), m_report(report)
  {}

  // Returns `false` if a vertex has no place in its star.
  bool run()
  {
    while(!m_mesh.records().empty()) {
      const int v = m_mesh.removed_vertex(m_mesh.records().back());
      m_mesh.undo();
      if(!insert(v))
        return false;
      smooth_around(v);
    }
    return true;
  }

private:
  // Steps 1 and 2
  bool insert(const int v)
  {
    m_star.gather(m_mesh, m_uv, v);
    m_uv[v] = abf::harmonic_position(m_star);
    if(abf::is_valid(m_star, m_uv[v]))
      return true;
    ++m_report.kernel_insertions;
    m_uv[v] = abf::kernel_centre(m_star);
    return abf::is_valid(m_star, m_uv[v]);
  }

  // Step 3: the neighbours, and then the vertex itself
  void smooth_around(const int v)
  {
    neighbours(m_mesh, v, m_ring);
    for(const int neighbour : m_ring)
      smooth(neighbour);
    smooth(v);
  }

  void smooth(const int v)
  {
    m_star.gather(m_mesh, m_uv, v);
    const abf::Planar_point place = abf::harmonic_position(m_star);
    const bool valid = abf::is_valid(m_star, place);
    if(valid)
      m_uv[v] = place;
    ++(valid ? m_report.moves : m_report.rejected_moves);
  }

  abf::Edge_collapses& m_mesh;
  std::vector<abf::Planar_point>& m_uv;
  SMP::Hierarchical_report& m_report;
  abf::Planar_star m_star;
  std::vector<int> m_ring;
};

// The whole method, with the interface of a parameterizer. A coarse chart that cannot be solved is an error.
template <class Mesh>
class Sequential_parameterizer
{
public:
  typedef Mesh Triangle_mesh;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

  explicit Sequential_parameterizer(const SMP::Hierarchical_options& options) : m_options(options) {}

  const SMP::Hierarchical_report& report() const { return m_outcome.report; }

  template <class UV_map, class Index_map, class Parameterized_map>
  SMP::Error_code parameterize(Mesh& mesh, const halfedge_descriptor border, UV_map uvmap, Index_map vimap,
                               Parameterized_map)
  {
    m_outcome = abf::run_parameterizer<SMP::Hierarchical_report>(
        mesh, border, uvmap, vimap, m_options,
        [&](abf::Chart& chart, abf::Rounding round) { return flatten(chart, round); });
    return error_code(m_outcome.report.diagnosis);
  }

private:
  typedef std::vector<abf::Chart::Point_2> Layout;
  typedef abf::Flattening<SMP::Hierarchical_report> Flattening;

  Flattening flatten(abf::Chart& chart, const abf::Rounding round)
  {
    Flattening result;
    SMP::Hierarchical_report& report = result.report = abf::report_of<SMP::Hierarchical_report>(chart);
    m_uv.assign(chart.points.size(), abf::Planar_point(0, 0));
    abf::Edge_collapses collapses(chart);
    {
      const abf::Stage stage(nullptr, SMP::Flattening_visitor::COARSEN, report.seconds.coarsen);
      coarsen(collapses);
    }
    bool solved = false, refined = false;
    {
      const abf::Stage stage(nullptr, SMP::Flattening_visitor::COARSE_CHART, report.seconds.coarse_chart);
      solved = solve_coarse(collapses, report);
    }
    {
      const abf::Stage stage(nullptr, SMP::Flattening_visitor::REFINE, report.seconds.refine);
      refined = solved && Sequential_refinement(collapses, m_uv, report).run();
    }
    if(!refined) {
      abf::fail(report, SMP::Flattening_report::NO_CONVERGENCE,
                solved ? "a vertex has no valid position in its star" : "the coarse chart cannot be solved");
      return result;
    }
    {
      const abf::Stage stage(nullptr, SMP::Flattening_visitor::CERTIFY, report.seconds.certify);
      certify(chart, round, result);
    }
    return result;
  }

  void coarsen(abf::Edge_collapses& collapses) const
  {
    const double target = (1 - m_options.simplification_rate) * collapses.chart().number_of_vertices();
    Sequential_coarsening(collapses, m_options.extreme_angle)
        .coarsen((std::max)(static_cast<int>(target), 100));
  }

  bool solve_coarse(const abf::Edge_collapses& collapses, SMP::Hierarchical_report& report)
  {
    std::vector<int> alive;
    for(int v = 0; v < collapses.chart().number_of_vertices(); ++v) {
      if(collapses.is_alive(v))
        alive.push_back(v);
    }
    const abf::Coarse_chart coarse(collapses, alive);
    report.coarse_vertices = coarse.chart.number_of_vertices();
    report.coarse_triangles = coarse.chart.number_of_triangles();
    SMP::ABF_plus_plus_parameterizer_3<SMP::Hierarchical_coarse_mesh> parameterizer;
    const auto uv = abf::Coarse_solver<decltype(parameterizer)>(parameterizer)(coarse.chart);
    if(!uv)
      return false;
    for(std::size_t v = 0; v < uv->size(); ++v)
      m_uv[alive[v]] = abf::Planar_point((*uv)[v].x(), (*uv)[v].y());
    return true;
  }

  // The map, scaled like that of the library. Flipped triangles are counted and an error.
  void certify(const abf::Chart& chart, const abf::Rounding round, Flattening& result) const
  {
    for(const abf::Planar_point& p : m_uv)
      result.uv.emplace_back(p.x(), p.y());
    abf::scale_to_surface_area(chart, result.uv);
    round(result.uv);
    result.invalid = abf::flipped_triangles(chart, result.uv);
    result.report.flipped_triangles = static_cast<int>(result.invalid.size());
    if(!result.invalid.empty()) {
      abf::fail(result.report, SMP::Flattening_report::FLIPPED_TRIANGLES,
                std::to_string(result.invalid.size()) + " flipped triangle(s)");
    }
  }

  SMP::Hierarchical_options m_options;
  abf::Outcome<Mesh, SMP::Hierarchical_report> m_outcome;
  std::vector<abf::Planar_point> m_uv; // of each vertex that is there
};

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_SEQUENTIAL_HIERARCHY_H
