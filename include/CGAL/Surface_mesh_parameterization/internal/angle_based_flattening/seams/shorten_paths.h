// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shortens seams by key-path exchange: takes a path between two branches away, and puts the shortest one in its place.
// `find_seams_impl.h` and `greedy_cones.h` run it after each cut, which is made greedily and is rarely shortest.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SHORTEN_PATHS_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SHORTEN_PATHS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/cut_topology.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/seams/shortest_paths.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Shortens seams by key-path exchange: without one path between two branches, what was a disk is an annulus, and the
// shortest path between its borders makes it a disk again. Ends of seams inside the surface, and terminals, are kept.
class Path_shortening
{
public:
  Path_shortening(Sector_graph& surface, const std::vector<double>& cost, const std::vector<int>& terminals)
      : m_surface(surface), m_cost(cost), m_is_terminal(surface.surface().points.size(), false),
        m_paths(surface, cost)
  {
    for(int v : terminals)
      m_is_terminal[v] = true;
  }

  // Searches visit at most `visits` nodes for each node of the surface, in all. Returns whether anything became
  // shorter.
  bool run(int visits)
  {
    m_visits_left = static_cast<std::int64_t>(visits) * m_surface.number_of_nodes();
    bool any = false;
    for(bool changed = true; changed && m_visits_left > 0;) {
      changed = false;
      for(const std::vector<int>& path : key_paths())
        if(m_visits_left > 0 && is_intact(path))
          changed |= exchange(path);
      any |= changed;
    }
    return any;
  }

  // The seams between ends, the longest ones first. A closed seam without any end is not among them.
  std::vector<std::vector<int>> key_paths() const
  {
    std::vector<std::pair<double, std::vector<int>>> paths;
    for(int c = 0; c < chart().number_of_corners(); ++c) {
      if(!m_surface.is_seam(c) || !is_end(next_corner(c)))
        continue;
      std::vector<int> path{c};
      while(!is_end(previous_corner(path.back())))
        path.push_back(continuation(path.back()));
      if(path.front() < chart().opposite[path.back()]) // not from its other end
        paths.emplace_back(-length(path), path);
    }
    std::sort(paths.begin(), paths.end());
    std::vector<std::vector<int>> result;
    for(auto& path : paths)
      result.push_back(std::move(path.second));
    return result;
  }

private:
  const Chart& chart() const { return m_surface.surface(); }

  double length(const std::vector<int>& path) const
  {
    return std::accumulate(path.begin(), path.end(), 0., [&](double sum, int c) { return sum + m_cost[c]; });
  }

  bool is_on_border_of_surface(int corner) const { return chart().interior[chart().vertex[corner]] < 0; }

  // Whether a path does not go on through the vertex
  bool is_end(int corner) const
  {
    return is_on_border_of_surface(corner) || m_is_terminal[chart().vertex[corner]] ||
           m_surface.seams_at(corner).size() != 2;
  }

  // The other one of two seams at the target of a seam
  int continuation(int c) const
  {
    const std::vector<int> seams = m_surface.seams_at(previous_corner(c));
    return seams.front() == chart().opposite[c] ? seams.back() : seams.front();
  }

  bool is_intact(const std::vector<int>& path) const
  {
    if(!is_end(next_corner(path.front())) || !is_end(previous_corner(path.back())))
      return false;
    for(std::size_t i = 0; i < path.size(); ++i)
      if(!m_surface.is_seam(path[i]) || (i > 0 && is_end(next_corner(path[i]))))
        return false;
    return true;
  }

  bool exchange(const std::vector<int>& path)
  {
    for(int c : path)
      m_surface.set_seam(c, false);
    std::vector<int> here = border_at(m_surface.source_node(path.front())),
                     there = border_at(m_surface.target_node(path.back()));
    std::vector<int> shorter;
    bool is_only_path = false;
    if(std::find(here.begin(), here.end(), there.front()) == here.end()) {
      is_only_path = here.size() == 1 && there.size() == 1;
      if(there.size() < here.size())
        here.swap(there);
      shorter = shortest_path(here, there, length(path));
    }
    // One edge alone would leave a disk with a border of two edges.
    const bool is_better = shorter.size() > (is_only_path ? 1 : 0);
    for(int c : is_better ? shorter : path)
      m_surface.set_seam(c, true);
    return is_better;
  }

  // The nodes of the border through a node, or the node alone if it is on none
  std::vector<int> border_at(int x) const
  {
    std::vector<int> nodes{x};
    if(m_surface.is_on_border(x)) {
      const int first = next_corner(m_surface.first_corner(x));
      for(int c = m_surface.next_open(first); c != first; c = m_surface.next_open(c))
        nodes.push_back(m_surface.target_node(c));
    }
    return nodes;
  }

  // A path that is shorter than `length`, or none
  std::vector<int> shortest_path(const std::vector<int>& from, const std::vector<int>& to, double length)
  {
    m_is_target.resize(m_surface.number_of_nodes(), false);
    for(int x : to)
      m_is_target[x] = true;
    const int x = m_paths.find(from, length * (1 - 1e-6), [&](int y) { return m_is_target[y]; });
    for(int y : to)
      m_is_target[y] = false;
    m_visits_left -= m_paths.number_of_visited_nodes();
    return x < 0 ? std::vector<int>() : m_paths.path(x);
  }

  Sector_graph& m_surface;
  const std::vector<double>& m_cost;
  std::vector<char> m_is_terminal; // of each vertex
  std::vector<char> m_is_target;   // of each node, during a search
  Shortest_paths m_paths;
  std::int64_t m_visits_left = 0;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_SEAMS_SHORTEN_PATHS_H
