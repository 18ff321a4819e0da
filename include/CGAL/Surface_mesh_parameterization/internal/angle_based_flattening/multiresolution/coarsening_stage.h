// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The levels of a coarsening on one copy of the chart (Section 5.1). Each removes independent vertices, the cheapest of
// a block first. `coarsen.h` chains such stages, and copies the chart in between to keep neighbours close in memory.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSENING_STAGE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSENING_STAGE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/collapse_cost.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/deadline.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Some levels of a coarsening, and the chart that they make coarser. No two vertices that a level removes are
// neighbours, so they can be inserted again in any order.
class Coarsening_stage
{
  static constexpr int block_of_vertices = 32768;

public:
  // `borders` are the vertices of each border cycle of the chart, in its order.
  Coarsening_stage(Chart& chart, Border_cycles borders)
      : m_mesh(chart), m_level_begin{0}, m_alive(chart.points.size()), m_borders(std::move(borders))
  {
    std::iota(m_alive.begin(), m_alive.end(), 0);
  }

  const Edge_collapses& mesh() const { return m_mesh; }
  int number_of_levels() const { return static_cast<int>(m_level_begin.size()) - 1; }
  int number_of_vertices() const { return static_cast<int>(m_alive.size()); }
  const std::vector<int>& alive() const { return m_alive; }

  // The vertices of each border cycle that are left, in its order. Collapses keep that.
  Border_cycles borders() const
  {
    Border_cycles result = m_borders;
    for(std::vector<int>& cycle : result)
      cycle.erase(std::remove_if(cycle.begin(), cycle.end(), [&](int v) { return !m_mesh.is_alive(v); }),
                  cycle.end());
    return result;
  }

  // Removes up to `quota` vertices. See `Collapse_cost` for `extreme_angle`.
  //
  // Blocks of vertices that are close in memory take turns, with the cheapest collapses of a block first: jumping in
  // memory to the cheapest collapses of all would take most of the time.
  void add_level(int quota, double extreme_angle)
  {
    const std::vector<Collapse_candidate> candidates = cheapest_collapses(extreme_angle);
    Collapse_cost cost(m_mesh, extreme_angle);
    std::vector<char> locked(m_mesh.chart().points.size(),
                             false); // whether the level has removed a neighbour
    const int n = number_of_vertices();
    int removed = 0;
    for(int begin = 0; begin < n; begin += block_of_vertices) {
      Deadline::ask();
      const int end = n - begin < block_of_vertices ? n : begin + block_of_vertices;
      const int allowed = static_cast<int>(std::int64_t(quota) * end / n);
      for(int i : ranked(candidates, begin, end)) {
        if(removed == allowed)
          break;
        removed += is_removed(m_alive[i], candidates[i].record, cost, locked);
      }
    }
    m_alive.erase(std::remove_if(m_alive.begin(), m_alive.end(), [&](int v) { return !m_mesh.is_alive(v); }),
                  m_alive.end());
    m_level_begin.push_back(static_cast<int>(m_mesh.records().size()));
  }

  // Returns memory that is not needed any more.
  void shrink() { m_alive.shrink_to_fit(); }

  // Undoes the coarsest level. Returns the vertices that this level had removed. Calls `visit` with each of them and
  // the vertex into which it had been merged.
  template <typename Visitor>
  std::vector<int> undo_level(const Visitor& visit)
  {
    m_level_begin.pop_back();
    std::vector<int> restored;
    while(static_cast<int>(m_mesh.records().size()) > m_level_begin.back()) {
      const int kept = m_mesh.kept_vertex(m_mesh.records().back());
      restored.push_back(m_mesh.undo());
      visit(restored.back(), kept);
    }
    // sorted by number, neighbours are close in memory
    std::sort(restored.begin(), restored.end());
    const auto middle = m_alive.insert(m_alive.end(), restored.begin(), restored.end());
    std::inplace_merge(m_alive.begin(), middle, m_alive.end());
    return restored;
  }

private:
  // The cheapest collapse of each remaining vertex
  std::vector<Collapse_candidate> cheapest_collapses(double extreme_angle) const
  {
    std::vector<Collapse_candidate> candidates(m_alive.size());
    parallel_for_blocks(number_of_vertices(), [&](int begin, int end) {
      Collapse_cost cost(m_mesh, extreme_angle);
      for(int i = begin; i < end; ++i)
        candidates[i] = cost.best(m_alive[i]);
    });
    return candidates;
  }

  // The numbers in a block of all allowed collapses, the cheapest first. Those whose costs differ by less than a factor
  // of two stay in the order of the vertices.
  static std::vector<int> ranked(const std::vector<Collapse_candidate>& candidates, int begin, int end)
  {
    std::map<int, std::vector<int>> of_exponent;
    for(int i = begin; i < end; ++i)
      if(candidates[i])
        of_exponent[std::ilogb(candidates[i].cost)].push_back(i);
    std::vector<int> result;
    for(const auto& [exponent, numbers] : of_exponent)
      result.insert(result.end(), numbers.begin(), numbers.end());
    return result;
  }

  // Collapses an edge of a vertex, unless a neighbour has been removed, and locks the neighbours. Returns whether it
  // did.
  bool is_removed(int v, Edge_collapses::Record record, Collapse_cost& cost, std::vector<char>& locked)
  {
    if(locked[v])
      return false;
    // nothing to check if neither star has changed
    if(locked[m_mesh.kept_vertex(record)] && !cost.is_still_allowed(v, record))
      return false;
    const Chart& chart = m_mesh.chart();
    m_mesh.for_each_corner(v, [&](int c) {
      locked[chart.vertex[next_corner(c)]] = locked[chart.vertex[previous_corner(c)]] = true;
    });
    m_mesh.collapse(record);
    return true;
  }

  Edge_collapses m_mesh;
  std::vector<int> m_level_begin; // first record of each level
  std::vector<int> m_alive;       // the remaining vertices, sorted
  Border_cycles m_borders;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSENING_STAGE_H
