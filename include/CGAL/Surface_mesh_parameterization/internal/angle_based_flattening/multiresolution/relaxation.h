// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Sweeps of relaxation over all vertices of a level (Section 5.2), in parallel, with the same result on any number of
// threads. `refine.h`, `relax_level.h`, `angle_descent.h` and `flatten_injectively.h` run them. `Local_border` is the
// policy without global tests.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAXATION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAXATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// In small blocks, many vertices have a neighbour in another block.
inline int number_of_vertex_blocks(int n)
{
  return (std::min)(1 + n / 4096, 16);
}

inline int begin_of_vertex_block(int b, int blocks, int n)
{
  return static_cast<int>(std::int64_t(n) * b / blocks);
}

// Lets the border of a map overlap itself, but not around a border vertex where it did not. `Border_keeper` keeps all
// of it simple.
class Local_border
{
public:
  Local_border(const Coarsening& coarsening, std::vector<Planar_point>& uv)
      : m_coarsening(coarsening), m_uv(uv)
  {}

  void take(const Coarsening&, const std::vector<Planar_point>&) {}
  bool touches_at(int) const { return false; }
  bool has_moved(int v, const Planar_point& before, const Planar_point&) { return !overlaps(v, before); }

  // Relaxes a vertex. Returns `false` if it does not move.
  template <typename Star>
  bool relax(const Star& star, int v, Planar_point& position)
  {
    const Planar_point before = position;
    const auto accept = [](const Planar_point&) { return true; };
    if(!(relax_vertex(star, position, accept) < 1))
      return false;
    if(!star.on_border || has_moved(v, before, position))
      return true;
    position = before;
    return false;
  }

private:
  // Whether the triangles around border vertex `v`, or around one of its neighbours on the border, nearly take a full
  // turn now, but did not take one with `v` at `before`. The chart could then overlap itself there although all
  // triangles are positively oriented. A position is not refused where the chart overlaps itself anyway. The rest of
  // the turn is for vertices that are still to be inserted.
  bool overlaps(int v, const Planar_point& before)
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
    const Chart& chart = m_coarsening.mesh().chart();
    const int first = m_coarsening.mesh().first_corner(v);
    int last = first;
    for(int c = first; c >= 0; c = chart.rotate(c))
      last = c;
    unsigned bits = 0;
    for(int w : {v, chart.vertex[previous_corner(first)], chart.vertex[next_corner(last)]})
      bits = 2 * bits + (turn(w) > limit);
    return bits;
  }

  // The sum of the angles of all triangles around `v`
  double turn(int v) const
  {
    double result = 0;
    const Chart& chart = m_coarsening.mesh().chart();
    m_coarsening.mesh().for_each_corner(v, [&](int c) {
      const Planar_point a = m_uv[chart.vertex[next_corner(c)]] - m_uv[v],
                         b = m_uv[chart.vertex[previous_corner(c)]] - m_uv[v];
      result += std::atan2(cross(a, b), a.dot(b));
    });
    return result;
  }

  const Coarsening& m_coarsening;
  std::vector<Planar_point>& m_uv;
};

// Moves the vertices of a map, one by one, to where the energy of their stars is lower. `Border` says where those on
// the border may be.
template <typename Border>
class Relaxation
{
public:
  Relaxation(const Coarsening& coarsening, std::vector<Planar_point>& uv, Border& border)
      : m_coarsening(coarsening), m_uv(uv), m_border(border)
  {}

  int moves() const { return m_moves; }
  int rejected_moves() const { return m_rejected_moves; }

  // Moves each vertex once. Blocks of consecutive vertices are processed in parallel. Border vertices and vertices
  // with a neighbour in another block are deferred until all blocks are done, so the result does not depend on the
  // number of threads.
  template <typename Star>
  void sweep(const Star& empty)
  {
    take_border();
    const std::vector<int>& vertices = m_coarsening.alive();
    const int n = static_cast<int>(vertices.size());
    const int blocks = number_of_vertex_blocks(n);
    m_blocks.resize(blocks);
    parallel_for(blocks, [&](int b) {
      Block& block = m_blocks[b];
      block.clear();
      const int begin = begin_of_vertex_block(b, blocks, n), end = begin_of_vertex_block(b + 1, blocks, n);
      Star star = empty;
      for(int i = begin; i < end; ++i) {
        const bool on_border = mesh().chart().interior[vertices[i]] < 0;
        if(!on_border)
          star.gather(mesh(), m_uv, vertices[i]);
        if(on_border || star.first_neighbour < vertices[begin] || star.last_neighbour > vertices[end - 1])
          block.deferred.push_back(vertices[i]);
        else
          relax(star, vertices[i], block);
      }
    });
    Star star = empty;
    for(Block& result : m_blocks) {
      for(int v : result.deferred) {
        Deadline::ask();
        star.gather(mesh(), m_uv, v);
        relax(star, v, result);
      }
      m_moves += result.moves;
      m_rejected_moves += result.rejected_moves;
    }
  }

  // Moves only these vertices, one after the other.
  template <typename Star>
  void move(const Star& empty, const std::vector<int>& vertices)
  {
    take_border();
    Star star = empty;
    for(int v : vertices) {
      star.gather(mesh(), m_uv, v);
      ++(m_border.relax(star, v, m_uv[v]) ? m_moves : m_rejected_moves);
    }
  }

  // Tells the border about vertices that were inserted, or moved by others.
  void take_border() { m_border.take(m_coarsening, m_uv); }

  bool border_touches(int v) const { return m_border.touches_at(v); }

  // Moves a border vertex from `before` to its position in the map, or back if the chart would overlap itself there.
  // Returns whether it stays.
  bool keep_border_position(int v, const Planar_point& before)
  {
    const bool is_kept = m_border.has_moved(v, before, m_uv[v]);
    if(!is_kept)
      m_uv[v] = before;
    return is_kept;
  }

private:
  const Edge_collapses& mesh() const { return m_coarsening.mesh(); }

  struct Block
  {
    int moves = 0, rejected_moves = 0;
    std::vector<int> deferred;

    void clear()
    {
      moves = rejected_moves = 0;
      deferred.clear();
    }
  };

  template <typename Star>
  void relax(const Star& star, int v, Block& result)
  {
    ++(m_border.relax(star, v, m_uv[v]) ? result.moves : result.rejected_moves);
  }

  const Coarsening& m_coarsening;
  std::vector<Planar_point>& m_uv;
  Border& m_border;
  int m_moves = 0, m_rejected_moves = 0;
  std::vector<Block> m_blocks; // of the last sweep
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAXATION_H
