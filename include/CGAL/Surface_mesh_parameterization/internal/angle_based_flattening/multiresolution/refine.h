// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_REFINE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_REFINE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Hierarchical_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/angle_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/insert_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Inserts the removed vertices again, level by level, and relaxes the map after each level (Section 5.2).
class Refinement
{
public:
  struct Counts
  {
    int kernel_insertions = 0, moves = 0, rejected_moves = 0;
  };

  Refinement(Coarsening& coarsening, std::vector<Planar_point>& uv) : m_coarsening(coarsening), m_uv(uv) {}

  const Counts& counts() const { return m_counts; }

  // Undoes all levels, with sweeps of relaxation on each. Returns `false` if a vertex has no valid position in its
  // star.
  bool run(int sweeps, Flattening_visitor* visitor)
  {
    sweep(sweeps);
    while(m_coarsening.number_of_levels() > 0) {
      if(!insert(m_coarsening.undo_level([&](int v, int kept) { m_uv[v] = m_uv[kept]; })))
        return false;
      visit_level(visitor, m_coarsening.number_of_vertices(),
                  m_coarsening.mesh().chart().number_of_vertices());
      // Coarse levels smooth errors of long wavelength. On the finest levels, sweeps cost most.
      const int large_levels = 3;
      sweep(m_coarsening.number_of_levels() < large_levels ? (std::min)(sweeps, 1) : sweeps);
    }
    return true;
  }

  // Sweeps over the finest level that lower the energy of the direct method.
  void lower_angle_energy(int sweeps, double barrier)
  {
    const std::vector<double> beta =
        sweeps > 0 ? target_angles(m_coarsening.mesh().chart()) : std::vector<double>();
    for(int i = 0; i < sweeps; ++i)
      relax_all(Angle_star(beta, Angle_energy{barrier}));
  }

private:
  void sweep(int times)
  {
    for(int i = 0; i < times; ++i)
      relax_all(MIPS_star());
  }

  // Counts of what happened to the vertices of a block
  struct Block_result
  {
    int moves = 0, rejected_moves = 0, kernel_insertions = 0;
    bool complete = true;
    std::vector<int> deferred;
  };

  // Vertices of a level are not neighbours, so all can be inserted in parallel.
  bool insert(const std::vector<int>& vertices)
  {
    const int n = static_cast<int>(vertices.size());
    const int blocks = number_of_blocks(n);
    std::vector<Block_result> results(blocks);
    parallel_for(blocks, [&](int b) {
      Planar_star star;
      const int end = begin_of_block(b + 1, blocks, n);
      for(int i = begin_of_block(b, blocks, n); results[b].complete && i < end; ++i) {
        star.gather(m_coarsening.mesh(), m_uv, vertices[i]);
        insert(star, vertices[i], results[b]);
        if(star.on_border)
          results[b].deferred.push_back(vertices[i]);
      }
    });
    Planar_star star;
    bool complete = true;
    for(Block_result& result : results) {
      for(std::size_t i = 0; result.complete && i < result.deferred.size(); ++i) {
        star.gather(m_coarsening.mesh(), m_uv, result.deferred[i]);
        widen(star, result.deferred[i]);
      }
      m_counts.kernel_insertions += result.kernel_insertions;
      complete = complete && result.complete;
    }
    return complete;
  }

  // A border vertex is inserted close to the present border, or to the vertex into which it was merged. The angles
  // around its neighbours are known only after all vertices of the level are inserted.
  void insert(const Planar_star& star, int v, Block_result& result)
  {
    const bool is_close = star.on_border && insert_closely(star, v);
    const Insertion insertion = is_close ? INSERTED : insert_vertex(star, m_uv[v]);
    // If the angles around a border vertex exceed a full turn, the triangles of a vertex split off it can all be
    // positively oriented and still wind around it twice. No other position helps: the set of valid positions is
    // convex, so the winding number is the same on all of it.
    const bool is_wound = insertion != NOT_INSERTED && !star.on_border && winding_number(star, m_uv[v]) != 1;
    result.kernel_insertions += insertion == INSERTED_IN_KERNEL;
    result.complete = insertion != NOT_INSERTED && !is_wound;
  }

  bool insert_closely(const Planar_star& star, int v)
  {
    const bool is_first = m_uv[v] == star.triangles.front().q; // the vertex into which it had been merged
    for(double distance : {1e-4, 1e-6, 1e-8}) {
      m_uv[v] =
          star.triangles.size() == 1 ? tip_of_ear(star, distance) : next_to_end(star, is_first, distance);
      if(is_valid(star, m_uv[v]))
        return true;
    }
    return false;
  }

  // Moves a border vertex to where it would be inserted, or as far towards there as the border does not overlap
  // itself.
  void widen(const Planar_star& star, int v)
  {
    const Planar_point close = m_uv[v];
    if(insert_vertex(star, m_uv[v]) != NOT_INSERTED && !border_overlaps(v, close))
      return;
    for(double distance : {0.5, 0.1, 0.01})
      for(const Planar_point& position : {tip_of_ear(star, distance), next_to_end(star, true, distance),
                                          next_to_end(star, false, distance)}) {
        m_uv[v] = position;
        if(is_valid(star, position) && !border_overlaps(v, close))
          return;
      }
    m_uv[v] = close;
  }

  // A position slightly outside the edge between the two neighbours on the border
  static Planar_point tip_of_ear(const Planar_star& star, double distance)
  {
    const Planar_point &a = star.triangles.front().q, &b = star.triangles.back().p;
    return (a + b) / 2 + distance * Planar_point(b.y() - a.y(), a.x() - b.x());
  }

  // A position next to the first or the last ring vertex of a border vertex, within the triangles between that vertex
  // and the other ring vertices. `distance` is relative to the nearest ring vertex. All triangles are valid close to
  // the vertex into which the border vertex had been merged.
  static Planar_point next_to_end(const Planar_star& star, bool first, double distance)
  {
    const Planar_star::Triangle &front = star.triangles.front(), &back = star.triangles.back();
    const Planar_point &end = first ? front.q : back.p, &neighbour = first ? front.p : back.q;
    double nearest = (neighbour - end).norm(), angle = 0;
    for(const Planar_star::Triangle& t : star.triangles)
      if(&t != (first ? &front : &back)) {
        const Planar_point p = t.p - end, q = t.q - end;
        nearest = (std::min)({nearest, p.norm(), q.norm()});
        angle += std::atan2(cross(p, q), p.dot(q));
      }
    const Planar_point along = (neighbour - end).normalized();
    const double c = std::cos(angle / 2), s = first ? -std::sin(angle / 2) : std::sin(angle / 2);
    return end +
           distance * nearest * Planar_point(c * along.x() - s * along.y(), s * along.x() + c * along.y());
  }

  // Whether the triangles around border vertex `v`, or around one of its neighbours on the border, nearly take a full
  // turn now, but did not take one with `v` at `before`. The chart could then overlap itself there although all
  // triangles are positively oriented. A position is not refused where the chart overlaps itself anyway. The rest of
  // the turn is for vertices that are still to be inserted.
  bool border_overlaps(int v, const Planar_point& before)
  {
    const unsigned now = wide_angles(v, 2 * pi - 1e-2);
    if(now == 0)
      return false;
    const Planar_point position = m_uv[v];
    m_uv[v] = before;
    const unsigned then = wide_angles(v, 2 * pi);
    m_uv[v] = position;
    return (now & ~then) != 0;
  }

  // One bit for border vertex `v` and one for each of its neighbours on the border
  unsigned wide_angles(int v, double limit) const
  {
    const Edge_collapses& mesh = m_coarsening.mesh();
    const int first = mesh.first_corner(v);
    int last = first;
    for(int c = first; c >= 0; c = mesh.chart().rotate(c))
      last = c;
    unsigned bits = 0;
    for(int w : {v, mesh.chart().vertex[previous_corner(first)], mesh.chart().vertex[next_corner(last)]})
      bits = 2 * bits + (turn(w) > limit);
    return bits;
  }

  // The sum of the angles of all triangles around `v`
  double turn(int v) const
  {
    const Chart& chart = m_coarsening.mesh().chart();
    double result = 0;
    m_coarsening.mesh().for_each_corner(v, [&](int c) {
      const Planar_point a = m_uv[chart.vertex[next_corner(c)]] - m_uv[v],
                         b = m_uv[chart.vertex[previous_corner(c)]] - m_uv[v];
      result += std::atan2(cross(a, b), a.dot(b));
    });
    return result;
  }

  // Moves each vertex once. Blocks of consecutive vertices are processed in parallel. Border vertices and vertices
  // with a neighbour in another block are deferred until all blocks are done, so the result does not depend on the
  // number of threads.
  template <typename Star>
  void relax_all(const Star& empty)
  {
    const std::vector<int>& vertices = m_coarsening.alive();
    const int n = static_cast<int>(vertices.size());
    const int blocks = number_of_blocks(n);
    std::vector<Block_result> results(blocks);
    parallel_for(blocks, [&](int b) {
      const int begin = begin_of_block(b, blocks, n), end = begin_of_block(b + 1, blocks, n);
      Star star = empty;
      for(int i = begin; i < end; ++i) {
        const bool on_border = m_coarsening.mesh().chart().interior[vertices[i]] < 0;
        if(!on_border)
          star.gather(m_coarsening.mesh(), m_uv, vertices[i]);
        if(on_border || star.first_neighbour < vertices[begin] || star.last_neighbour > vertices[end - 1])
          results[b].deferred.push_back(vertices[i]);
        else
          relax(star, vertices[i], results[b]);
      }
    });
    Star star = empty;
    for(Block_result& result : results) {
      for(int v : result.deferred) {
        star.gather(m_coarsening.mesh(), m_uv, v);
        relax(star, v, result);
      }
      m_counts.moves += result.moves;
      m_counts.rejected_moves += result.rejected_moves;
    }
  }

  template <typename Star>
  void relax(const Star& star, int v, Block_result& result)
  {
    const Planar_point position = m_uv[v];
    bool moved = relax_vertex(star, m_uv[v]);
    if(moved && star.on_border && border_overlaps(v, position)) {
      m_uv[v] = position;
      moved = false;
    }
    ++(moved ? result.moves : result.rejected_moves);
  }

  // In small blocks, many vertices have a neighbour in another block.
  static int number_of_blocks(int n) { return (std::min)(1 + n / 4096, 16); }

  static int begin_of_block(int b, int blocks, int n)
  {
    return static_cast<int>(std::int64_t(n) * b / blocks);
  }

  Coarsening& m_coarsening;
  std::vector<Planar_point>& m_uv;
  Counts m_counts;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_REFINE_H
