// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_COARSEN_H
#define CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_COARSEN_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/collapse_cost.h>
#include <CGAL/Surface_mesh_parameterization/internal/hierarchical_flattening/edge_collapses.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {

namespace Surface_mesh_parameterization {

namespace internal {

// Makes a chart coarser level by level. The vertices that a level removes are independent: none is a neighbour of
// another one, so that they can be put back in any order.
class Coarsening
{
public:
  explicit Coarsening(Chart& chart) : m_mesh(chart), m_level_begin{0}
  {
    for(int v = 0; v < chart.number_of_vertices(); ++v)
      m_alive.push_back(v);
  }

  const Edge_collapses& mesh() const { return m_mesh; }
  Edge_collapses& mesh() { return m_mesh; }
  int number_of_levels() const { return static_cast<int>(m_level_begin.size()) - 1; }
  int number_of_vertices() const { return static_cast<int>(m_alive.size()); }
  const std::vector<int>& alive() const { return m_alive; }

  // Adds levels until at most `target` vertices are left, or hardly any more can be removed. For `extreme_angle` see
  // `Collapse_cost`.
  void coarsen(int target, double extreme_angle)
  {
    Collapse_cost cost(m_mesh, extreme_angle);
    while(number_of_vertices() > target) {
      const int before = number_of_vertices();
      add_level((std::min)(before - target, before / 4 + 1), cost);
      if(before - number_of_vertices() < 0.01 * before)
        break;
    }
  }

  // Undoes the coarsest level. Returns the records that were undone, the last one first.
  std::vector<Edge_collapses::Record> undo_level()
  {
    const std::vector<Edge_collapses::Record>& records = m_mesh.records();
    m_level_begin.pop_back();
    const std::vector<Edge_collapses::Record> undone(records.begin() + m_level_begin.back(), records.end());
    for(std::size_t i = 0; i < undone.size(); ++i)
      m_mesh.undo();
    for(Edge_collapses::Record record : undone)
      m_alive.push_back(m_mesh.removed_vertex(record));
    return {undone.rbegin(), undone.rend()};
  }

private:
  struct Ranked
  {
    double cost;
    int vertex;
    Edge_collapses::Record record;
  };

  void add_level(int quota, Collapse_cost& cost)
  {
    std::vector<Ranked> ranked;
    for(int v : m_alive)
      if(const Collapse_candidate candidate = cost.best(v))
        ranked.push_back({candidate.cost, v, candidate.record});
    std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
      return a.cost < b.cost || (a.cost == b.cost && a.vertex < b.vertex);
    });

    const Chart& chart = m_mesh.chart();
    std::vector<char> locked(chart.points.size(), false);
    for(const Ranked& next : ranked) {
      if(quota == 0)
        break;
      if(locked[next.vertex] || !cost.is_still_allowed(next.vertex, next.record))
        continue;
      m_mesh.for_each_corner(next.vertex, [&](int c) {
        locked[chart.vertex[next_corner(c)]] = locked[chart.vertex[previous_corner(c)]] = true;
      });
      m_mesh.collapse(next.record);
      --quota;
    }
    m_alive.erase(std::remove_if(m_alive.begin(), m_alive.end(), [&](int v) { return !m_mesh.is_alive(v); }),
                  m_alive.end());
    m_level_begin.push_back(static_cast<int>(m_mesh.records().size()));
  }

  Edge_collapses m_mesh;
  std::vector<int> m_level_begin; // first record of each level
  std::vector<int> m_alive;       // the vertices that are there
};

} // namespace internal

} // namespace Surface_mesh_parameterization

} // namespace CGAL

#endif // CGAL_SMP_INTERNAL_HIERARCHICAL_FLATTENING_COARSEN_H
