// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The way back from a coarse map to the whole chart: inserts the vertices of a level, then relaxes it (Section 5.2).
// `coarse_to_fine.h` and `flatten_injectively.h` run it. A border policy decides whether the border may overlap
// itself.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_REFINE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_REFINE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/angle_energy.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/insert_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_level.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relaxation.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Inserts the removed vertices again, level by level, and relaxes the map after each level (Section 5.2).
template <typename Relaxation>
class Refinement
{
public:
  Refinement(Coarsening& coarsening, std::vector<Planar_point>& uv, Relaxation& relaxation)
      : m_coarsening(coarsening), m_uv(uv), m_relaxation(relaxation)
  {}

  int kernel_insertions() const { return m_kernel_insertions; }

  // Undoes all levels, with sweeps of relaxation on each, by the energy of angles if there is one, or else by MIPS.
  // Returns `false` if a vertex has no valid position in its star.
  bool run(int sweeps, const std::optional<Angle_energy>& angles, Flattening_visitor* visitor)
  {
    relax(sweeps, angles);
    while(m_coarsening.number_of_levels() > 0) {
      if(!undo_level(visitor))
        return false;
      // Coarse levels smooth errors of long wavelength. On the finest levels, sweeps cost most.
      const int large_levels = 3;
      const bool is_large = m_coarsening.number_of_levels() < large_levels;
      relax(is_large ? (std::min)(sweeps, 1) : sweeps, angles);
    }
    return true;
  }

  // Inserts the vertices of the coarsest level. Returns `false` if a vertex has no valid position in its star.
  bool undo_level(Flattening_visitor* visitor)
  {
    if(!insert(m_coarsening.undo_level(m_uv)))
      return false;
    visit_level(visitor, m_coarsening.number_of_vertices(), m_coarsening.mesh().chart().number_of_vertices());
    return true;
  }

private:
  void relax(int sweeps, const std::optional<Angle_energy>& angles)
  {
    if(angles)
      relax_angles_of_level(m_coarsening, m_relaxation, sweeps, *angles);
    else
      relax_level(m_coarsening, m_relaxation, sweeps);
  }

  // What happened to the vertices of a block
  struct Block_result
  {
    int kernel_insertions = 0;
    bool complete = true;
    std::vector<int> deferred;
  };

  // Vertices of a level are not neighbours, so all can be inserted in parallel.
  bool insert(const std::vector<int>& vertices)
  {
    const int n = static_cast<int>(vertices.size());
    const int blocks = number_of_vertex_blocks(n);
    std::vector<Block_result> results(blocks);
    parallel_for(blocks, [&](int b) {
      Planar_star star;
      const int end = begin_of_vertex_block(b + 1, blocks, n);
      for(int i = begin_of_vertex_block(b, blocks, n); results[b].complete && i < end; ++i) {
        star.gather(m_coarsening.mesh(), m_uv, vertices[i]);
        insert(star, vertices[i], results[b]);
        if(star.on_border)
          results[b].deferred.push_back(vertices[i]);
      }
    });
    m_relaxation.take_border();
    Planar_star star;
    bool complete = true;
    for(Block_result& result : results) {
      for(std::size_t i = 0; result.complete && i < result.deferred.size(); ++i) {
        star.gather(m_coarsening.mesh(), m_uv, result.deferred[i]);
        result.complete = flatten_ear(star, result.deferred[i]);
        widen(star, result.deferred[i]);
      }
      m_kernel_insertions += result.kernel_insertions;
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

  // An ear is inserted outside the present border, and must not touch it. Returns `false` if it always does.
  bool flatten_ear(const Planar_star& star, int v)
  {
    for(double distance = 1e-6; m_relaxation.border_touches(v); distance *= 1e-2) {
      const Planar_point position = tip_of_ear(star, distance);
      if(star.triangles.size() > 1 || !is_valid(star, position))
        return false;
      m_relaxation.keep_border_position(v, m_uv[v] = position);
    }
    return true;
  }

  // Moves a border vertex to where it would be inserted, or as far towards there as the border does not overlap
  // itself.
  void widen(const Planar_star& star, int v)
  {
    const Planar_point close = m_uv[v];
    if(insert_vertex(star, m_uv[v]) != NOT_INSERTED && m_relaxation.keep_border_position(v, close))
      return;
    for(double distance : {0.5, 0.1, 0.01})
      for(const Planar_point& position : {tip_of_ear(star, distance), next_to_end(star, true, distance),
                                          next_to_end(star, false, distance)}) {
        m_uv[v] = position;
        if(is_valid(star, position) && m_relaxation.keep_border_position(v, close))
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

  Coarsening& m_coarsening;
  std::vector<Planar_point>& m_uv;
  Relaxation& m_relaxation;
  int m_kernel_insertions = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_REFINE_H
