// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAXATION_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAXATION_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/injective/border_keeper.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/relax_vertex.h>
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

// Moves the vertices of a map, one by one, to where the energy of their stars is lower.
class Relaxation
{
public:
  // With a `keeper`, the border stays simple. Otherwise it stays simple around each border vertex if it was.
  Relaxation(const Coarsening& coarsening, std::vector<Planar_point>& uv, Border_keeper* keeper = nullptr)
      : m_coarsening(coarsening), m_uv(uv), m_keeper(keeper)
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
    std::vector<Block> results(blocks);
    parallel_for(blocks, [&](int b) {
      const int begin = begin_of_vertex_block(b, blocks, n), end = begin_of_vertex_block(b + 1, blocks, n);
      Star star = empty;
      for(int i = begin; i < end; ++i) {
        const bool on_border = mesh().chart().interior[vertices[i]] < 0;
        if(!on_border)
          star.gather(mesh(), m_uv, vertices[i]);
        if(on_border || star.first_neighbour < vertices[begin] || star.last_neighbour > vertices[end - 1])
          results[b].deferred.push_back(vertices[i]);
        else
          relax(star, vertices[i], results[b]);
      }
    });
    Star star = empty;
    for(Block& result : results) {
      for(int v : result.deferred) {
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
      ++(is_relaxed(star, v) ? m_moves : m_rejected_moves);
    }
  }

  // Tells the keeper of the border about vertices that were inserted, or moved by others.
  void take_border()
  {
    if(m_keeper != nullptr)
      m_keeper->take(m_coarsening.borders(), m_uv);
  }

  // Whether the border touches itself at a border vertex, if there is someone who keeps it simple.
  bool border_touches(int v) const { return m_keeper != nullptr && m_keeper->touches_at(v); }

  // Moves a border vertex from `before` to its position in the map, or back if the chart would overlap itself there. Returns
  // whether it stays.
  bool keep_border_position(int v, const Planar_point& before)
  {
    const bool is_kept =
        m_keeper != nullptr ? m_keeper->try_to_move(v, m_uv[v]) : !border_overlaps(v, before);
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
  };

  template <typename Star>
  void relax(const Star& star, int v, Block& result)
  {
    ++(is_relaxed(star, v) ? result.moves : result.rejected_moves);
  }

  template <typename Star>
  bool is_relaxed(const Star& star, int v)
  {
    const auto accept = [](const Planar_point&) { return true; };
    if(m_keeper != nullptr)
      return star.on_border ? m_keeper->relax(star, v, m_uv[v])
                            : relax_vertex_repeatedly(star, m_uv[v], accept) < 1;
    const Planar_point before = m_uv[v];
    return relax_vertex(star, m_uv[v], accept) < 1 && (!star.on_border || keep_border_position(v, before));
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
    const Chart& chart = mesh().chart();
    const int first = mesh().first_corner(v);
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
    const Chart& chart = mesh().chart();
    mesh().for_each_corner(v, [&](int c) {
      const Planar_point a = m_uv[chart.vertex[next_corner(c)]] - m_uv[v],
                         b = m_uv[chart.vertex[previous_corner(c)]] - m_uv[v];
      result += std::atan2(cross(a, b), a.dot(b));
    });
    return result;
  }

  const Coarsening& m_coarsening;
  std::vector<Planar_point>& m_uv;
  Border_keeper* m_keeper;
  int m_moves = 0, m_rejected_moves = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_RELAXATION_H
