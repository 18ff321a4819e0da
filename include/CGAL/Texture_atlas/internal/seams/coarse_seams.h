// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A simplified copy of a large surface, shortest paths that carry seams of the copy over to the surface, and their
// repair, so that they open it to a disk there, too. `find_seams_impl.h` selects seams on the copy, where each
// prediction of the scale costs far less.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_COARSE_SEAMS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_COARSE_SEAMS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Flattening_options.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/coarsen.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/cut_topology.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// A coarse copy of a surface, on which seams are selected faster
class Coarse_copy
{
public:
  Coarse_copy(const Chart& surface, const std::vector<double>& cost, int vertices)
      : m_surface(surface), m_cost(cost)
  {
    Chart copy = surface;
    Coarsening coarsening(copy);
    coarsening.coarsen(vertices, Hierarchical_options().extreme_angle);
    Coarse_chart coarse = coarsening.coarse_chart();
    m_coarse = std::move(coarse.chart);
    m_fine_vertex = coarsening.original(coarse.vertices);
    find_members(coarse.vertices, coarsening);
  }

  const Chart& chart() const { return m_coarse; }
  int fine_vertex(int v) const { return m_fine_vertex[v]; }

  // The cost of the edge that each corner of the copy faces: its length times what a unit of it costs around its ends
  std::vector<double> cost() const
  {
    std::vector<double> sum(m_surface.points.size(), 0.), length(m_surface.points.size(), 0.);
    for(int c = 0; c < m_surface.number_of_corners(); ++c)
      if(m_cost[c] < forbidden)
        for(int v : {m_surface.edge_source(c), m_surface.edge_target(c)}) {
          sum[v] += m_cost[c];
          length[v] += edge_length(m_surface, c);
        }
    const auto unit_cost = [&](int v) {
      const int fine = m_fine_vertex[v];
      return length[fine] > 0 ? sum[fine] / length[fine] : 1;
    };
    std::vector<double> result;
    for(int c = 0; c < m_coarse.number_of_corners(); ++c)
      result.push_back(edge_length(m_coarse, c) *
                       (unit_cost(m_coarse.edge_source(c)) + unit_cost(m_coarse.edge_target(c))) / 2);
    return result;
  }

  // Draws paths of the copy, given by their edges, on the surface: each becomes the shortest path between its ends that
  // stays near it, or the shortest anywhere where edges that must not become seams bar all of these. Returns whether
  // all stay near.
  bool draw(const std::vector<std::vector<int>>& paths, Sector_graph& surface) const
  {
    std::vector<int> node(m_surface.points.size()), seams;
    for(int c = 0; c < m_surface.number_of_corners(); ++c)
      node[m_surface.vertex[c]] = surface.node(c);
    bool all_are_near = true;
    for(const std::vector<int>& path : paths) {
      if(m_coarse.edge_source(path.front()) != m_coarse.edge_target(path.back())) {
        all_are_near &= find_fine_path(path, node, {}, surface, seams);
      } else {
        const auto middle = path.begin() + static_cast<std::ptrdiff_t>(path.size() / 2);
        std::vector<int> half;
        all_are_near &= find_fine_path({path.begin(), middle}, node, {}, surface, half);
        all_are_near &= find_fine_path({middle, path.end()}, node, half, surface, seams);
        seams.insert(seams.end(), half.begin(), half.end());
      }
    }
    for(int c : seams)
      if(!surface.is_seam(c))
        surface.set_seam(c, true);
    return all_are_near;
  }

private:
  // The vertices of the surface that were merged into each vertex of the copy
  void find_members(const std::vector<int>& remaining, Coarsening& coarsening)
  {
    std::vector<int> member_of(coarsening.mesh().chart().points.size(), -1);
    for(std::size_t i = 0; i < remaining.size(); ++i)
      member_of[remaining[i]] = static_cast<int>(i);
    while(coarsening.number_of_levels() > 0)
      coarsening.undo_level(member_of);
    m_members.resize(m_fine_vertex.size());
    for(std::size_t v = 0; v < member_of.size(); ++v)
      m_members[member_of[v]].push_back(static_cast<int>(v));
  }

  // Appends the edges of the fine path of a path that is not closed. It does not cross the inside of another one,
  // `avoided`. Returns whether it stays near.
  bool find_fine_path(const std::vector<int>& path, const std::vector<int>& node,
                      const std::vector<int>& avoided, const Sector_graph& surface,
                      std::vector<int>& edges) const
  {
    const int from = node[m_fine_vertex[m_coarse.edge_source(path.front())]],
              to = node[m_fine_vertex[m_coarse.edge_target(path.back())]];
    std::vector<char> is_allowed = nodes_near(path, node);
    for(bool is_near : {true, false}) {
      for(int c : avoided)
        for(int x : {surface.source_node(c), surface.target_node(c)})
          is_allowed[x] = x == from || x == to;
      Shortest_paths fine(surface, m_cost);
      if(fine.find(
             {from}, forbidden, [&](int x) { return x == to; }, [&](int x) { return is_allowed[x]; }) >= 0) {
        const std::vector<int> found = fine.path(to);
        edges.insert(edges.end(), found.begin(), found.end());
        return is_near;
      }
      is_allowed.assign(is_allowed.size(), true);
    }
    return false;
  }

  // The nodes that were merged into the path's vertices, and into all their neighbours
  std::vector<char> nodes_near(const std::vector<int>& path, const std::vector<int>& node) const
  {
    std::vector<char> is_near(m_coarse.points.size(), false);
    for(int edge : path)
      for(int end : {next_corner(edge), previous_corner(edge)})
        for(int c : corners_around(m_coarse, end))
          is_near[m_coarse.vertex[next_corner(c)]] = is_near[m_coarse.vertex[previous_corner(c)]] = true;
    std::vector<char> result(m_surface.points.size(), false);
    for(std::size_t i = 0; i < is_near.size(); ++i)
      if(is_near[i])
        for(int v : m_members[i])
          result[node[v]] = true;
    return result;
  }

  const Chart& m_surface;
  const std::vector<double>& m_cost;
  Chart m_coarse;
  std::vector<int> m_fine_vertex;
  std::vector<std::vector<int>> m_members;
};

// Makes a disk of a connected surface whose seams nearly do so, by taking away and adding as little as possible: paths
// that are drawn on the fine surface may meet or miss one another.
class Cut_repair
{
public:
  Cut_repair(Sector_graph& surface, const std::vector<double>& cost, const std::vector<int>& terminals)
      : m_surface(surface), m_cost(cost), m_is_terminal(surface.surface().points.size(), false)
  {
    for(int v : terminals)
      m_is_terminal[v] = true;
  }

  // Returns `false` if edges that must not become seams leave no way.
  bool run()
  {
    join_parts();
    prune();
    return Topological_cut(m_surface, m_cost).run();
  }

private:
  const Chart& chart() const { return m_surface.surface(); }

  std::vector<int> seams() const
  {
    std::vector<int> result;
    for(int c = 0; c < chart().number_of_corners(); ++c)
      if(m_surface.is_seam(c) && c < chart().opposite[c])
        result.push_back(c);
    return result;
  }

  // Without the longest seams between two parts, there is one.
  void join_parts()
  {
    Disjoint_sets sets(chart().number_of_triangles());
    for(int c = 0; c < chart().number_of_corners(); ++c)
      if(!m_surface.is_open(c))
        sets.union_set(c / 3, chart().opposite[c] / 3);
    std::vector<int> longest_first = seams();
    std::stable_sort(longest_first.begin(), longest_first.end(),
                     [&](int c, int d) { return m_cost[c] > m_cost[d]; });
    for(int c : longest_first)
      if(sets.find_set(c / 3) != sets.find_set(chart().opposite[c] / 3)) {
        sets.union_set(c / 3, chart().opposite[c] / 3);
        m_surface.set_seam(c, false);
      }
  }

  // Removes ends of seams inside the surface that are not terminals.
  void prune()
  {
    for(int seam : seams())
      for(int c : {seam, chart().opposite[seam]})
        while(m_surface.is_seam(c) && is_needless_end(previous_corner(c))) {
          const int source = next_corner(c);
          m_surface.set_seam(c, false);
          const std::vector<int> others = m_surface.seams_at(source);
          if(others.size() != 1)
            break;
          c = chart().opposite[others.front()];
        }
  }

  bool is_needless_end(int corner) const
  {
    const int v = chart().vertex[corner];
    return chart().interior[v] >= 0 && !m_is_terminal[v] && m_surface.number_of_seams_at(corner) == 1;
  }

  Sector_graph& m_surface;
  const std::vector<double>& m_cost;
  std::vector<char> m_is_terminal; // of each vertex
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_COARSE_SEAMS_H
