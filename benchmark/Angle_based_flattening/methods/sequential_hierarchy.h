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

#include "methods.h"

#include <CGAL/Surface_mesh_parameterization/ABF_plus_plus_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Hierarchical_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/scale.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarse_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/collapse_cost.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/insert_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/coarse_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/write_chart.h>

#include <boost/heap/d_ary_heap.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace ABF_benchmark {

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
  Sequential_refinement(abf::Edge_collapses& mesh, std::vector<abf::Planar_point>& uv)
      : m_mesh(mesh), m_uv(uv)
  {}

  int kernel_insertions() const { return m_kernel_insertions; }

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
    ++m_kernel_insertions;
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
    if(abf::is_valid(m_star, place))
      m_uv[v] = place;
  }

  abf::Edge_collapses& m_mesh;
  std::vector<abf::Planar_point>& m_uv;
  int m_kernel_insertions = 0;
  abf::Planar_star m_star;
  std::vector<int> m_ring;
};

// Solves the coarse chart by direct ABF++. Returns whether that worked.
inline bool solve_coarse_chart(const abf::Coarse_chart& coarse, const std::vector<int>& alive,
                               std::vector<abf::Planar_point>& uv)
{
  SMP::ABF_plus_plus_parameterizer_3<SMP::Hierarchical_coarse_mesh> parameterizer;
  const auto coarse_uv = abf::Coarse_solver<decltype(parameterizer)>(parameterizer)(coarse.chart);
  for(std::size_t v = 0; coarse_uv && v < coarse_uv->size(); ++v)
    uv[alive[v]] = abf::Planar_point((*coarse_uv)[v].x(), (*coarse_uv)[v].y());
  return coarse_uv.has_value();
}

// The whole method, with the stages of the library's. A coarse chart that cannot be solved is an error.
inline void run_sequential_hierarchy(Surface& surface, const SMP::Hierarchical_options& options,
                                     Measurement& m)
{
  const Gauge gauge;
  abf::Chart_reader<Mesh> reader(surface.mesh);
  auto defect = reader.read(surface.border);
  if(!defect)
    defect = abf::diagnose(reader.chart, false);
  if(defect)
    return m.fail(defect.message);
  const int vertices = reader.chart.number_of_vertices();
  abf::Edge_collapses collapses(reader.chart);
  m.add("coarsen", seconds_of([&] {
          const int target = static_cast<int>((1 - options.simplification_rate) * vertices);
          Sequential_coarsening(collapses, options.extreme_angle).coarsen((std::max)(target, 100));
        }));

  std::vector<int> alive;
  for(int v = 0; v < vertices; ++v)
    if(collapses.is_alive(v))
      alive.push_back(v);
  std::vector<abf::Planar_point> places(vertices, abf::Planar_point(0, 0));
  bool succeeded = false;
  m.add("solve", seconds_of([&] {
          const abf::Coarse_chart coarse(collapses, alive);
          m.add("coarse_triangles", coarse.chart.number_of_triangles());
          succeeded = solve_coarse_chart(coarse, alive, places);
        }));
  if(!succeeded)
    return m.fail("the coarse chart cannot be solved");

  Sequential_refinement refinement(collapses, places);
  m.add("refine", seconds_of([&] { succeeded = refinement.run(); }));
  m.add("kernel_insertions", refinement.kernel_insertions());
  if(!succeeded)
    return m.fail("a vertex has no valid position in its star");

  std::vector<abf::Chart::Point_2> uv;
  for(const abf::Planar_point& p : places)
    uv.emplace_back(p.x(), p.y());
  abf::scale_to_surface_area(reader.chart, uv);
  if(const std::size_t flips = abf::flipped_triangles(reader.chart, uv).size())
    return m.fail(std::to_string(flips) + " flipped triangle(s)");
  abf::write_chart(reader, uv, surface.uv);
  gauge.add_to(m);
}

} // namespace ABF_benchmark

#endif // ABF_BENCHMARK_SEQUENTIAL_HIERARCHY_H
