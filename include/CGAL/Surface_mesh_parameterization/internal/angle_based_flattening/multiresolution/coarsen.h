// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSEN_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSEN_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarse_chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/collapse_cost.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/parallel.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Makes a chart coarser level by level. No two vertices that a level removes are neighbours, so they can be inserted
// again in any order.
class Coarsening
{
public:
  explicit Coarsening(Chart& chart) : m_mesh(chart), m_level_begin{0}
  {
    for(int v = 0; v < chart.number_of_vertices(); ++v)
      m_alive.push_back(v);
    if(chart.borders.size() > 1)
      for(int c : chart.borders.front())
        m_outer_border.push_back(chart.edge_source(c));
    std::sort(m_outer_border.begin(), m_outer_border.end());
  }

  // What is left of the chart, with the same outer border
  Coarse_chart coarse_chart() const { return Coarse_chart(m_mesh, m_alive, m_outer_border); }

  const Edge_collapses& mesh() const { return m_mesh; }
  Edge_collapses& mesh() { return m_mesh; }
  int number_of_levels() const { return static_cast<int>(m_level_begin.size()) - 1; }
  int number_of_vertices() const { return static_cast<int>(m_alive.size()); }
  const std::vector<int>& alive() const { return m_alive; }

  // Adds levels until at most `target` vertices are left or hardly any vertex can be removed. See `Collapse_cost` for
  // `extreme_angle`.
  void coarsen(int target, double extreme_angle, Flattening_visitor* visitor = nullptr)
  {
    while(number_of_vertices() > target) {
      const int before = number_of_vertices();
      add_level((std::min)(before - target, before / 4 + 1), extreme_angle);
      visit_level(visitor, number_of_vertices(), m_mesh.chart().number_of_vertices());
      if(before - number_of_vertices() < 0.01 * before)
        break;
    }
  }

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

  std::vector<int> undo_level()
  {
    return undo_level([](int, int) {});
  }

private:
  void add_level(int quota, double extreme_angle)
  {
    const std::vector<Collapse_candidate> candidates = cheapest_collapses(extreme_angle);
    Collapse_cost cost(m_mesh, extreme_angle);
    const Chart& chart = m_mesh.chart();
    std::vector<char> locked(chart.points.size(), false);
    for(int i : ranked(candidates)) {
      if(quota == 0)
        break;
      const int v = m_alive[i];
      if(locked[v])
        continue;
      // nothing to check if neither star has changed
      if(locked[m_mesh.kept_vertex(candidates[i].record)] && !cost.is_still_allowed(v, candidates[i].record))
        continue;
      m_mesh.for_each_corner(v, [&](int c) {
        locked[chart.vertex[next_corner(c)]] = locked[chart.vertex[previous_corner(c)]] = true;
      });
      m_mesh.collapse(candidates[i].record);
      --quota;
    }
    m_alive.erase(std::remove_if(m_alive.begin(), m_alive.end(), [&](int v) { return !m_mesh.is_alive(v); }),
                  m_alive.end());
    m_level_begin.push_back(static_cast<int>(m_mesh.records().size()));
  }

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

  // The numbers of all allowed collapses, the cheapest first. Those whose costs differ by less than a factor of two
  // stay in the order of the vertices, because jumps in memory would take most of the time.
  static std::vector<int> ranked(const std::vector<Collapse_candidate>& candidates)
  {
    std::map<int, std::vector<int>> of_exponent;
    for(std::size_t i = 0; i < candidates.size(); ++i)
      if(candidates[i])
        of_exponent[std::ilogb(candidates[i].cost)].push_back(static_cast<int>(i));
    std::vector<int> result;
    for(const auto& [exponent, numbers] : of_exponent)
      result.insert(result.end(), numbers.begin(), numbers.end());
    return result;
  }

  Edge_collapses m_mesh;
  std::vector<int> m_level_begin;  // first record of each level
  std::vector<int> m_alive;        // the remaining vertices, sorted
  std::vector<int> m_outer_border; // its vertices before all collapses, sorted, if there are other borders
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSEN_H
