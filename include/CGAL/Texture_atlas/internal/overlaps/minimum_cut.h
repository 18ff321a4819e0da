// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The cheapest seam between two sheets of a map that overlap, as a minimum cut of the dual graph. `separate_overlaps.h`
// makes one such cut after the other. The paper splits its charts by Sheffer and Hart (2002) instead.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_MINIMUM_CUT_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_MINIMUM_CUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/maximum_flow.h>
#include <CGAL/Texture_atlas/internal/overlaps/dual_patch.h>
#include <CGAL/Texture_atlas/internal/overlaps/sheets.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// The cheapest cut of a patch between two sheets, as a maximum flow on its dual graph. Each sheet is one node, and so
// is each block of triangles that must not be separated.
class Minimum_cut
{
public:
  Minimum_cut(const Dual_patch& patch, const std::vector<Sheet>& sheet, const std::vector<int>& block)
      : m_patch(patch)
  {
    number_nodes(sheet, block);
    find_maximum_flow();
  }

  // Whether a triangle is on the side of the first sheet
  bool is_on_first_side(int triangle) const { return m_on_first_side[m_node[triangle]]; }

private:
  void number_nodes(const std::vector<Sheet>& sheet, const std::vector<int>& block)
  {
    std::vector<int> node_of_block(block.size(), -1);
    for(std::size_t t = 0; t < block.size(); ++t) {
      int& node = node_of_block[block[t]];
      if(node < 0)
        node = sheet[t] == Sheet::FIRST    ? static_cast<int>(Flow_network::SOURCE)
               : sheet[t] == Sheet::SECOND ? static_cast<int>(Flow_network::SINK)
                                           : m_network.number_of_nodes++;
      m_node.push_back(node);
    }
  }

  // A corner that faces an edge between two nodes is an edge of the dual graph, from its triangle to the other one.
  void find_maximum_flow()
  {
    const std::vector<int>& opposite = m_patch.chart.opposite;
    const auto node = [&](int corner) { return m_node[corner / 3]; };
    std::vector<int> corners;
    for(int c = 0; c < static_cast<int>(opposite.size()); ++c)
      if(opposite[c] >= 0 && node(c) != node(opposite[c]))
        corners.push_back(c);
    std::stable_sort(corners.begin(), corners.end(), [&](int c, int d) { return node(c) < node(d); });

    std::vector<int> rank(opposite.size(), -1);
    for(int c : corners) {
      rank[c] = static_cast<int>(m_network.edges.size());
      m_network.edges.emplace_back(node(c), node(opposite[c]));
      m_network.capacity.push_back(m_patch.cost[c]);
    }
    for(int c : corners)
      m_network.reverse.push_back(rank[opposite[c]]);
    m_on_first_side = maximum_flow(m_network).is_reached;
  }

  const Dual_patch& m_patch;
  Flow_network m_network;
  std::vector<int> m_node; // of each triangle
  std::vector<char> m_on_first_side;
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_MINIMUM_CUT_H
