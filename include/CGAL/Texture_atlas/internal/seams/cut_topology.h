// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Seams that open a connected surface of any genus to a disk: a Steiner tree of borders and terminals by Mehlhorn
// (1988), handles by Erickson and Whittlesey (2005). `find_seams_impl.h` and `coarse_seams.h` cut
// with it. The paper cuts its closed models by Sheffer and Hart (2002).

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CUT_TOPOLOGY_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CUT_TOPOLOGY_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/seams/shortest_paths.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Opens a connected surface until it is a disk that can be flattened, along short paths that reach all terminals.
class Topological_cut
{
public:
  Topological_cut(Sector_graph& surface, const std::vector<double>& cost,
                  const std::vector<int>& terminals = {})
      : m_surface(surface), m_cost(cost), m_terminals(interior_nodes(surface, terminals))
  {}

  // Returns `false` if edges that must not become seams leave no way.
  bool run()
  {
    const Topology topology(m_surface);
    const std::size_t ends = topology.borders + m_terminals.size();
    if(ends > 1 && !join_borders())
      return false;
    if(topology.handles > 0)
      cut_handles();
    else if(ends < 2 && topology.borders == 0)
      open_sphere();
    if(const Topology opened(m_surface); opened.is_disk() && !opened.can_be_flattened())
      lengthen_border();
    return Topology(m_surface).can_be_flattened();
  }

private:
  // An edge between two regions, and the length of the path that it closes
  struct Bridge
  {
    double length;
    int edge;

    friend bool operator<(const Bridge& a, const Bridge& b)
    {
      return a.length != b.length ? a.length < b.length : a.edge < b.edge;
    }
  };

  const Chart& chart() const { return m_surface.surface(); }

  // The nodes of those of some vertices that are neither on a border nor on a seam, each once
  static std::vector<int> interior_nodes(const Sector_graph& surface, const std::vector<int>& vertices)
  {
    if(vertices.empty())
      return {};
    std::vector<char> is_wanted(surface.surface().points.size(), false);
    for(int v : vertices)
      is_wanted[v] = true;
    std::vector<int> nodes;
    for(int x = 0; x < surface.number_of_nodes(); ++x)
      if(surface.is_node(x) && !surface.is_on_border(x) && is_wanted[surface.vertex(x)])
        nodes.push_back(x);
    return nodes;
  }

  std::vector<Bridge> bridges(const Shortest_paths& paths) const
  {
    std::vector<Bridge> found;
    for(int c = 0; c < chart().number_of_corners(); ++c)
      if(c < chart().opposite[c] && !m_surface.is_seam(c) && can_be_seam(c, paths))
        found.push_back(
            {paths.distance(m_surface.source_node(c)) + m_cost[c] + paths.distance(m_surface.target_node(c)),
             c});
    return found;
  }

  bool can_be_seam(int c, const Shortest_paths& paths) const
  {
    return m_cost[c] < forbidden && paths.is_reached(m_surface.source_node(c)) &&
           paths.is_reached(m_surface.target_node(c));
  }

  // Opens the edge, and the paths to its ends.
  void open_along(const Shortest_paths& paths, int edge, std::vector<int>& seams) const
  {
    seams.push_back(edge);
    for(int x : {m_surface.source_node(edge), m_surface.target_node(edge)}) {
      const std::vector<int> path = paths.path(x);
      seams.insert(seams.end(), path.begin(), path.end());
    }
  }

  void open(const std::vector<int>& seams)
  {
    for(int c : seams)
      if(!m_surface.is_seam(c))
        m_surface.set_seam(c, true);
  }

  // Mehlhorn's approximation of a Steiner tree of the borders and terminals: Kruskal's algorithm on the edges between
  // the regions that are nearest to each of them
  bool join_borders()
  {
    int borders = 0;
    std::vector<int> region = number_borders(m_surface, borders), sources = border_nodes(m_surface);
    for(int x : m_terminals) {
      region[x] = borders++;
      sources.push_back(x);
    }
    Shortest_paths paths(m_surface, m_cost);
    paths.find_all(sources);
    spread(paths, region);
    std::vector<Bridge> between = bridges(paths);
    between.erase(std::remove_if(between.begin(), between.end(),
                                 [&](const Bridge& bridge) {
                                   return region[m_surface.source_node(bridge.edge)] ==
                                          region[m_surface.target_node(bridge.edge)];
                                 }),
                  between.end());
    std::sort(between.begin(), between.end());
    Disjoint_sets sets(borders);
    std::vector<int> seams;
    for(const Bridge& bridge : between) {
      const int r = region[m_surface.source_node(bridge.edge)],
                s = region[m_surface.target_node(bridge.edge)];
      if(sets.find_set(r) == sets.find_set(s))
        continue;
      sets.union_set(r, s);
      open_along(paths, bridge.edge, seams);
      --borders;
    }
    open(seams);
    return borders == 1;
  }

  // Assigns each node to the region of the source of its path.
  void spread(const Shortest_paths& paths, std::vector<int>& region) const
  {
    for(int x = 0; x < m_surface.number_of_nodes(); ++x) {
      if(!m_surface.is_node(x))
        continue;
      int root = x;
      while(region[root] < 0 && paths.last_edge(root) >= 0)
        root = m_surface.source_node(paths.last_edge(root));
      const int r = region[root];
      for(int y = x; region[y] < 0 && paths.last_edge(y) >= 0; y = m_surface.source_node(paths.last_edge(y)))
        region[y] = r;
    }
  }

  // The greedy homotopy basis of Erickson and Whittlesey: a tree of shortest paths, a spanning tree of the triangles
  // across the other edges that prefers edges of long loops, and the loops of the 2g edges that are left
  void cut_handles()
  {
    std::vector<int> sources = border_nodes(m_surface);
    if(sources.empty())
      sources.push_back(m_terminals.empty() ? root() : m_terminals.front());
    Shortest_paths paths(m_surface, m_cost);
    paths.find_all(sources);
    std::vector<char> is_in_tree(chart().vertex.size(), false);
    for(int x = 0; x < m_surface.number_of_nodes(); ++x)
      if(m_surface.is_node(x) && paths.last_edge(x) >= 0)
        is_in_tree[paths.last_edge(x)] = is_in_tree[chart().opposite[paths.last_edge(x)]] = true;

    Disjoint_sets sets(chart().number_of_triangles());
    const auto join = [&](int c) {
      const auto s = sets.find_set(c / 3), t = sets.find_set(chart().opposite[c] / 3);
      if(s == t)
        return false;
      sets.link(s, t);
      return true;
    };
    for(int c = 0; c < chart().number_of_corners(); ++c)
      if(c < chart().opposite[c] && !m_surface.is_seam(c) && !can_be_seam(c, paths))
        join(c);
    std::vector<Bridge> others = bridges(paths);
    others.erase(std::remove_if(others.begin(), others.end(),
                                [&](const Bridge& bridge) { return is_in_tree[bridge.edge]; }),
                 others.end());
    std::sort(others.rbegin(), others.rend());
    std::vector<int> seams;
    for(const Bridge& bridge : others)
      if(!join(bridge.edge))
        open_along(paths, bridge.edge, seams);
    open(seams);
  }

  // A node from which seams may lead to as many others as possible
  int root() const
  {
    Disjoint_sets sets(m_surface.number_of_nodes());
    for(int c = 0; c < chart().number_of_corners(); ++c)
      if(!m_surface.is_open(c) && m_cost[c] < forbidden)
        sets.union_set(m_surface.source_node(c), m_surface.target_node(c));
    std::vector<int> size(m_surface.number_of_nodes(), 0);
    for(int x = 0; x < m_surface.number_of_nodes(); ++x)
      ++size[sets.find_set(x)];
    return static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  }

  // Opens a path between two vertices that are far from each other, or from the terminal to one that is far from it.
  void open_sphere()
  {
    int from = m_terminals.empty() ? root() : m_terminals.front(), to = from;
    std::vector<int> path;
    for(int sweep = m_terminals.empty() ? 0 : 1; sweep < 2; ++sweep) {
      from = to;
      Shortest_paths paths(m_surface, m_cost);
      paths.find_all({from});
      for(int x = 0; x < m_surface.number_of_nodes(); ++x)
        if(x != from && paths.is_reached(x) && (to == from || paths.distance(x) > paths.distance(to)))
          to = x;
      path = paths.path(to);
    }
    open(path);
  }

  // Makes the seam of one edge longer: another way between two terminals, or else one more edge, the cheapest between
  // the border of the disk and its interior.
  void lengthen_border()
  {
    if(m_terminals.size() == 2 && take_detour())
      return;
    int cheapest = -1;
    for(int c = 0; c < chart().number_of_corners(); ++c)
      if(!m_surface.is_open(c) && m_surface.is_on_border(m_surface.source_node(c)) &&
         !m_surface.is_on_border(m_surface.target_node(c)) && m_cost[c] < forbidden &&
         (cheapest < 0 || m_cost[c] < m_cost[cheapest]))
        cheapest = c;
    if(cheapest >= 0)
      open({cheapest});
  }

  // Opens the second shortest way between the ends of the only seam. Returns whether there is one.
  bool take_detour()
  {
    int edge = 0;
    while(!m_surface.is_seam(edge))
      ++edge;
    m_surface.set_seam(edge, false);
    std::vector<double> cost = m_cost;
    cost[edge] = cost[chart().opposite[edge]] = forbidden;
    const int to = m_surface.target_node(edge);
    Shortest_paths paths(m_surface, cost);
    const bool is_found =
        paths.find({m_surface.source_node(edge)}, forbidden, [&](int x) { return x == to; }) >= 0;
    open(is_found ? paths.path(to) : std::vector<int>{edge});
    return is_found;
  }

  Sector_graph& m_surface;
  const std::vector<double>& m_cost;
  const std::vector<int> m_terminals; // nodes inside the surface
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_CUT_TOPOLOGY_H
