// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Shortens seams by key-path exchange: takes a path between two branches away, and puts the shortest one in its place.
// `find_seams_impl.h` runs it after each cut, which is made greedily and is rarely shortest.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SHORTEN_PATHS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SHORTEN_PATHS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/seams/nearest_seams.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Shortens seams by key-path exchange: without one path between two branches, what was a disk is an annulus, and the
// shortest path between its borders makes it a disk again. Ends of seams inside the surface, and terminals, are kept.
class Path_shortening
{
public:
  // With `leaves_disks`, the seams leave disks and nothing else, and exchanges take far less time.
  Path_shortening(Sector_graph& surface, const std::vector<double>& cost,
                  const std::vector<int>& terminals = {}, bool leaves_disks = true)
      : m_surface(surface), m_cost(cost), m_is_terminal(surface.surface().points.size(), false)
  {
    add_terminals(terminals);
    if(leaves_disks) {
      m_nearest.emplace(m_surface, m_cost);
      m_crossing.emplace(m_surface, m_cost, *m_nearest);
    } else {
      m_paths.emplace(m_surface, m_cost);
    }
  }

  void add_terminals(const std::vector<int>& terminals)
  {
    for(int v : terminals)
      m_is_terminal[v] = true;
  }

  // Searches visit at most `visits` nodes for each node of the surface, in all. Returns whether anything became
  // shorter.
  bool run(int visits)
  {
    const std::int64_t most_visits = static_cast<std::int64_t>(visits) * m_surface.number_of_nodes();
    m_visits_left = most_visits;
    if(m_nearest)
      m_nearest->find();
    bool any = false;
    for(bool changed = true; changed && m_visits_left > 0;) {
      changed = false;
      for(const std::vector<int>& path : key_paths())
        if(m_visits_left > 0 && is_intact(path))
          changed |= exchange(path);
      any |= changed;
    }
    m_visits = most_visits - m_visits_left;
    return any;
  }

  std::int64_t number_of_visits() const { return m_visits; } // of nodes, by the exchanges of the last run

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

  // The length of paths that are shorter, and not only by rounding
  double longest_exchange(const std::vector<int>& path) const { return length(path) * (1 - 1e-6); }

  bool is_on_border_of_surface(int corner) const { return chart().interior[chart().vertex[corner]] < 0; }

  // Whether a path does not go on through the vertex
  bool is_end(int corner) const
  {
    return is_on_border_of_surface(corner) || m_is_terminal[chart().vertex[corner]] ||
           m_surface.number_of_seams_at(corner) != 2;
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
    if(length(path) <= 0) // nothing is shorter: paths of no length would be exchanged for each other for ever
      return false;
    return m_nearest ? exchange_on_disk(path) : exchange_anywhere(path);
  }

  bool exchange_on_disk(const std::vector<int>& path)
  {
    const std::int64_t before = m_nearest->number_of_visits();
    const double bound = longest_exchange(path);
    m_nearest->close(path, bound / 2);
    const int from = m_surface.source_node(path.front()), to = m_surface.target_node(path.back());
    const std::vector<int> shorter = m_crossing->shortest_path(path, from, to, bound);
    const bool is_better = is_accepted(shorter, from, to);
    m_nearest->reopen(path);
    if(is_better) {
      m_nearest->close(path);
      m_nearest->open(shorter);
    }
    m_visits_left -= m_nearest->number_of_visits() - before;
    return is_better;
  }

  bool exchange_anywhere(const std::vector<int>& path)
  {
    set_seams(path, false);
    const int from = m_surface.source_node(path.front()), to = m_surface.target_node(path.back());
    const std::vector<int> shorter = search(path, from, to);
    const bool is_better = is_accepted(shorter, from, to);
    set_seams(is_better ? shorter : path, true);
    return is_better;
  }

  // Whether there is a path between these nodes. One edge alone would leave a disk with a border of two edges.
  bool is_accepted(const std::vector<int>& path, int from, int to) const
  {
    const bool is_only_path = !m_surface.is_on_border(from) && !m_surface.is_on_border(to);
    return path.size() > (is_only_path ? 1 : 0);
  }

  void set_seams(const std::vector<int>& path, bool are_seams)
  {
    for(int c : path)
      m_surface.set_seam(c, are_seams);
  }

  // A path that is shorter than `path`, where there may be other borders between its ends than theirs, or none
  std::vector<int> search(const std::vector<int>& path, int from, int to)
  {
    std::vector<int> here = border_at(from), there = border_at(to);
    if(std::find(here.begin(), here.end(), there.front()) != here.end())
      return {};
    if(there.size() < here.size())
      here.swap(there);
    return shortest_path(here, there, longest_exchange(path));
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

  // At most as long as `bound`, or none
  std::vector<int> shortest_path(const std::vector<int>& from, const std::vector<int>& to, double bound)
  {
    m_is_target.resize(m_surface.number_of_nodes(), false);
    for(int x : to)
      m_is_target[x] = true;
    const int x = m_paths->find(from, bound, [&](int y) { return m_is_target[y]; });
    for(int y : to)
      m_is_target[y] = false;
    m_visits_left -= m_paths->number_of_visited_nodes();
    return x < 0 ? std::vector<int>() : m_paths->path(x);
  }

  Sector_graph& m_surface;
  const std::vector<double>& m_cost;
  std::vector<char> m_is_terminal;        // of each vertex
  std::optional<Nearest_seams> m_nearest; // if the seams leave disks
  std::optional<Annulus_crossing> m_crossing;
  std::optional<Shortest_paths> m_paths; // otherwise
  std::vector<char> m_is_target;         // of each node, during a search of these
  std::int64_t m_visits_left = 0, m_visits = 0;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_SHORTEN_PATHS_H
