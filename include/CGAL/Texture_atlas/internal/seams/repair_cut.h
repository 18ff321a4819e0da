// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Turns seams that nearly open a surface to a disk into ones that do, by taking away and adding as little as possible.
// `find_seams_impl.h` needs it after `coarse_seams.h`: paths that are drawn on the fine surface may meet or miss one
// another.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_REPAIR_CUT_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_REPAIR_CUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Texture_atlas/internal/seams/cut_topology.h>
#include <CGAL/Texture_atlas/internal/seams/sector_graph.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Makes a disk of a connected surface whose seams nearly do so: removes seams that divide it or lead nowhere, and adds
// missing ones.
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

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_SEAMS_REPAIR_CUT_H
