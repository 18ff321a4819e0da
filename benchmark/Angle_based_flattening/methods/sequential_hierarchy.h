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
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/collapse_cost.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/insert_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/strategies/coarse_solver.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>

#include <boost/heap/d_ary_heap.hpp>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

namespace ABF_benchmark {

inline std::vector<int> neighbours(const abf::Edge_collapses& mesh, const int v)
{
  const abf::Chart& chart = mesh.chart();
  std::vector<int> ring;
  mesh.for_each_corner(v, [&](const int c) {
    ring.push_back(chart.vertex[abf::previous_corner(c)]);
    if(chart.rotate(c) < 0)
      ring.push_back(chart.vertex[abf::next_corner(c)]);
  });
  return ring;
}

// A vertex in the queue, whose top is the largest entry
struct Ranked_vertex
{
  abf::Collapse_candidate candidate;
  int vertex;

  bool operator<(const Ranked_vertex& other) const
  {
    return std::tie(candidate.cost, vertex) > std::tie(other.candidate.cost, other.vertex);
  }
};

// Removes the vertex whose collapse is the cheapest of all, again and again, until `target` vertices are left, or no
// collapse is allowed any more.
inline void coarsen_sequentially(abf::Edge_collapses& mesh, const double extreme_angle, const int target)
{
  typedef boost::heap::d_ary_heap<Ranked_vertex, boost::heap::arity<4>, boost::heap::mutable_<true>> Queue;
  int vertices = mesh.chart().number_of_vertices();
  abf::Collapse_cost cost(mesh, extreme_angle);
  Queue queue;
  std::vector<Queue::handle_type> handles(vertices);
  for(int v = 0; v < vertices; ++v)
    handles[v] = queue.push({cost.best(v), v});
  const auto rank = [&](const int v) { queue.update(handles[v], {cost.best(v), v}); };
  while(vertices > target && queue.top().candidate) {
    const Ranked_vertex next = queue.top();
    // Changes outside of the star can forbid a collapse too.
    if(!cost.is_still_allowed(next.vertex, next.candidate.record)) {
      rank(next.vertex);
      continue;
    }
    const std::vector<int> ring = neighbours(mesh, next.vertex);
    queue.erase(handles[next.vertex]);
    mesh.collapse(next.candidate.record);
    for(const int v : ring)
      rank(v);
    --vertices;
  }
}

// Inserts the vertices again, one by one (Section 5.2), and counts those that are placed in the kernel. Returns
// `false` if a vertex has no place in its star.
inline bool refine_sequentially(abf::Edge_collapses& mesh, std::vector<abf::Planar_point>& uv,
                                int& kernel_insertions)
{
  abf::Planar_star star;
  const auto smooth = [&](const int v) {
    star.gather(mesh, uv, v);
    const abf::Planar_point place = abf::harmonic_position(star);
    if(abf::is_valid(star, place))
      uv[v] = place;
  };
  while(!mesh.records().empty()) {
    const int v = mesh.removed_vertex(mesh.records().back());
    mesh.undo();
    star.gather(mesh, uv, v); // steps 1 and 2
    uv[v] = abf::harmonic_position(star);
    if(!abf::is_valid(star, uv[v])) {
      ++kernel_insertions;
      uv[v] = abf::kernel_centre(star);
      if(!abf::is_valid(star, uv[v]))
        return false;
    }
    for(const int neighbour : neighbours(mesh, v)) // step 3
      smooth(neighbour);
    smooth(v);
  }
  return true;
}

// Solves the coarse chart by direct ABF++. Returns whether that worked.
inline bool solve_coarse_chart(const abf::Coarse_chart& coarse, const std::vector<int>& alive,
                               std::vector<abf::Planar_point>& uv)
{
  SMP::ABF_plus_plus_parameterizer_3<SMP::Hierarchical_coarse_mesh> parameterizer;
  const auto coarse_uv = abf::Coarse_solver<decltype(parameterizer)>(parameterizer)(coarse.chart).uv;
  for(std::size_t v = 0; coarse_uv && v < coarse_uv->size(); ++v)
    uv[alive[v]] = abf::Planar_point((*coarse_uv)[v].x(), (*coarse_uv)[v].y());
  return coarse_uv.has_value();
}

// The whole method, with the same stages as in the library. A coarse chart that cannot be solved is an error.
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
          coarsen_sequentially(collapses, options.extreme_angle, (std::max)(target, 100));
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

  int kernel_insertions = 0;
  m.add("refine", seconds_of([&] { succeeded = refine_sequentially(collapses, places, kernel_insertions); }));
  m.add("kernel_insertions", kernel_insertions);
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
