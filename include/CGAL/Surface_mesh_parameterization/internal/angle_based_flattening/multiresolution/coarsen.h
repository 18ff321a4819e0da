// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Simplification of a chart level by level (Section 5.1), and the way back. The paper collapses one edge at a time.
// `coarse_to_fine.h`, `flatten_injectively.h` and `seams/coarse_seams.h` coarsen with it; `refine.h` undoes the
// levels.
//
// What collapses leave of a chart, copied into a chart of its own, so that methods for any chart can flatten it
// (Section 5). `coarsen.h` makes its stages of it, `coarse_to_fine.h` the chart to be solved, and
// `seams/coarse_seams.h` a copy to cut.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSEN_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSEN_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsening_stage.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/edge_collapses.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/run/stage.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// What remains of a chart after collapses, as a separate chart, without borders and constraint nodes. Vertices and
// triangles keep their order.
struct Remaining_chart
{
  Chart chart;
  std::vector<int> vertices; // of each vertex of the coarse chart: its number in the fine one

  Remaining_chart(const Edge_collapses& mesh, const std::vector<int>& alive) : vertices(alive)
  {
    const Chart& fine = mesh.chart();
    chart.scale = fine.scale;
    std::vector<int> rank(fine.points.size(), -1);
    chart.points.reserve(alive.size());
    chart.interior.reserve(alive.size());
    for(int v : alive) {
      rank[v] = chart.number_of_vertices();
      chart.points.push_back(fine.points[v]);
      if(static_cast<std::size_t>(v) < fine.numbers.size())
        chart.numbers.push_back(fine.numbers[v]);
      chart.interior.push_back(fine.interior[v] < 0 ? -1 : chart.number_of_interior_vertices++);
    }
    copy_triangles(fine, rank, mesh.remaining_triangles());
  }

private:
  void copy_triangles(const Chart& fine, const std::vector<int>& vertex_rank,
                      const std::vector<int>& triangles)
  {
    std::vector<int> triangle_rank(fine.number_of_triangles(), -1);
    for(std::size_t t = 0; t < triangles.size(); ++t)
      triangle_rank[triangles[t]] = static_cast<int>(t);
    chart.vertex.reserve(3 * triangles.size());
    chart.opposite.reserve(3 * triangles.size());
    for(int t : triangles)
      for(int c = 3 * t; c < 3 * t + 3; ++c) {
        const int across = fine.opposite[c];
        chart.vertex.push_back(vertex_rank[fine.vertex[c]]);
        chart.opposite.push_back(across < 0 ? -1 : 3 * triangle_rank[across / 3] + across % 3);
      }
    if(!fine.weight.empty())
      for(int t : triangles)
        chart.weight.push_back(fine.weight[t]);
  }
};

// The same with borders
struct Coarse_chart : Remaining_chart
{
  // The first border is the one with vertices of `outer_border`, which may be empty if there is only one.
  Coarse_chart(const Edge_collapses& mesh, const std::vector<int>& alive, std::vector<int> outer_border = {})
      : Remaining_chart(mesh, alive)
  {
    std::sort(outer_border.begin(), outer_border.end());
    find_borders(chart, corner_at_border(outer_border));
  }

private:
  // A corner that faces a border edge from one of these vertices, which are sorted, or -1
  int corner_at_border(const std::vector<int>& border) const
  {
    for(int c = 0; c < chart.number_of_corners() && !border.empty(); ++c)
      if(chart.opposite[c] < 0 &&
         std::binary_search(border.begin(), border.end(), vertices[chart.edge_source(c)]))
        return c;
    return -1;
  }
};

// Makes a chart coarser level by level.
//
// The vertices of coarse levels would be scattered over the memory. Each time half of the vertices are gone, the others
// are therefore copied into a chart of their own, with numbers of its own: the next stage. All numbers of vertices here
// are those of the last stage.
class Coarsening
{
public:
  explicit Coarsening(Chart& chart) : m_chart(chart)
  {
    m_stages.push_back({nullptr, {chart, border_cycles(chart)}});
  }

  // What is left of the chart, with the same outer border
  Coarse_chart coarse_chart() const
  {
    const Border_cycles cycles = borders();
    return Coarse_chart(mesh(), alive(), cycles.size() > 1 ? cycles.front() : std::vector<int>());
  }

  const Edge_collapses& mesh() const { return stage().mesh(); }
  const std::vector<int>& alive() const { return stage().alive(); }
  int number_of_vertices() const { return stage().number_of_vertices(); }

  // The vertices of each border cycle
  Border_cycles borders() const { return stage().borders(); }

  int number_of_levels() const
  {
    int levels = 0;
    for(const Stage& s : m_stages)
      levels += s.coarsening.number_of_levels();
    return levels;
  }

  // The numbers of vertices in the whole chart
  std::vector<int> original(std::vector<int> vertices) const
  {
    for(auto s = m_stages.rbegin(); s->chart; ++s)
      for(int& v : vertices)
        v = s->chart->vertices[v];
    return vertices;
  }

  // The values at the vertices that are left: the sums of those at the vertices of the whole chart that were merged
  // there
  template <typename Value>
  std::vector<Value> merged(std::vector<Value> values) const
  {
    for(const Stage& s : m_stages) {
      if(s.chart) {
        for(std::size_t i = 0; i < s.chart->vertices.size(); ++i)
          values[i] = values[s.chart->vertices[i]];
        values.resize(s.chart->vertices.size());
      }
      const Edge_collapses& collapses = s.coarsening.mesh();
      for(const Edge_collapses::Record record : collapses.records())
        values[collapses.kept_vertex(record)] += values[collapses.removed_vertex(record)];
    }
    return values;
  }

  // Adds levels until at most `target` vertices are left or hardly any vertex can be removed. See `Collapse_cost` for
  // `extreme_angle`.
  void coarsen(int target, double extreme_angle, Flattening_visitor* visitor = nullptr)
  {
    while(number_of_vertices() > target) {
      const int before = number_of_vertices();
      if(2 * before <= mesh().chart().number_of_vertices())
        add_stage();
      stage().add_level((std::min)(before - target, before / 4 + 1), extreme_angle);
      visit_level(visitor, number_of_vertices(), m_chart.number_of_vertices());
      if(before - number_of_vertices() < 0.01 * before)
        break;
    }
  }

  // Undoes the coarsest level. Returns the vertices that this level had removed. Each gets the value of the vertex into
  // which it had been merged; the values of the others follow their numbers.
  template <typename Value>
  std::vector<int> undo_level(std::vector<Value>& values)
  {
    if(stage().number_of_levels() == 0)
      values = drop_stage(values);
    return stage().undo_level([&](int v, int kept) { values[v] = values[kept]; });
  }

  std::vector<int> undo_level()
  {
    std::vector<char> nothing(mesh().chart().points.size());
    return undo_level(nothing);
  }

private:
  struct Stage
  {
    std::unique_ptr<Remaining_chart> chart; // of all but the first stage
    Coarsening_stage coarsening;
  };

  const Coarsening_stage& stage() const { return m_stages.back().coarsening; }
  Coarsening_stage& stage() { return m_stages.back().coarsening; }

  void add_stage()
  {
    if(m_stages.size() == 1)
      release_nodes();
    stage().shrink();
    auto chart = std::make_unique<Remaining_chart>(mesh(), alive());
    Border_cycles cycles = borders();
    for(std::vector<int>& cycle : cycles)
      for(int& v : cycle) // `vertices` is sorted
        v = static_cast<int>(std::lower_bound(chart->vertices.begin(), chart->vertices.end(), v) -
                             chart->vertices.begin());
    Chart& remaining = chart->chart;
    m_stages.push_back({std::move(chart), {remaining, std::move(cycles)}});
  }

  // Returns to the stage before, which has all vertices of the last one. Returns the values of its vertices.
  template <typename Value>
  std::vector<Value> drop_stage(const std::vector<Value>& values)
  {
    const std::vector<int> vertices = std::move(m_stages.back().chart->vertices);
    m_stages.pop_back();
    if(m_stages.size() == 1)
      restore_nodes();
    std::vector<Value> result(mesh().chart().points.size());
    for(std::size_t i = 0; i < vertices.size(); ++i)
      result[vertices[i]] = values[i];
    return result;
  }

  // The constraints of the whole chart would wait in memory while the coarse one is solved. Those at interior vertices,
  // which are all alike, can be made again.
  void release_nodes()
  {
    m_has_released_nodes =
        !m_chart.node.empty() && m_chart.number_of_nodes() == m_chart.number_of_interior_vertices;
    if(m_has_released_nodes) {
      m_chart.node = std::vector<int>();
      m_chart.nodes = std::vector<Constraint_node>();
    }
  }

  void restore_nodes()
  {
    if(m_has_released_nodes) {
      m_chart.node = m_chart.interior;
      m_chart.nodes.assign(m_chart.number_of_interior_vertices, Constraint_node());
    }
  }

  Chart& m_chart;
  bool m_has_released_nodes = false;
  std::vector<Stage> m_stages;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_COARSEN_H
