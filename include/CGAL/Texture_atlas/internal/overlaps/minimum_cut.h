// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The cheapest seam between two sheets of a map that overlap, as a minimum cut of the dual graph. `separate_overlaps.h`
// makes one such cut after the other. The paper splits its charts by Sheffer and Hart (2002) instead.
//
// A connected part of a chart as a chart of its own, opened along seams, which still knows its triangles in the whole.
// `separate_overlaps.h` and `minimum_cut.h` cut such patches. `atlas/` opens and divides surfaces with it, `cones/`
// opens one along seams.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_MINIMUM_CUT_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_OVERLAPS_MINIMUM_CUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/maximum_flow.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/find_borders.h>
#include <CGAL/Texture_atlas/internal/overlaps/sheets.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal {

// Some connected triangles of a chart, opened along the seams among them
struct Dual_patch
{
  std::vector<int> triangles; // their numbers in the whole chart, by rising number
  Chart chart;
  std::vector<double> cost; // of the edge that each corner faces
  std::vector<int> origin;  // of each vertex: the one in the whole chart

  int whole_corner(int c) const { return 3 * triangles[c / 3] + c % 3; }

  // The vertices minus the edges plus the triangles; 1 for a disk
  int euler_characteristic() const
  {
    int sides = 0;
    for(int c = 0; c < chart.number_of_corners(); ++c)
      sides += chart.opposite[c] >= 0 ? 1 : 2;
    return chart.number_of_vertices() - sides / 2 + chart.number_of_triangles();
  }
};

// Cuts patches out of a chart.
class Patch_cutter
{
public:
  Patch_cutter(const Chart& whole, const std::vector<double>& cost)
      : m_whole(whole), m_cost(cost), m_local(whole.number_of_triangles(), -1)
  {}

  // `is_seam` is that of the edge that each corner of the chart faces. The patch knows the other sides of its seams,
  // also of those where the chart was open before.
  Dual_patch cut_out(std::vector<int> triangles, const std::vector<char>& is_seam)
  {
    Dual_patch patch;
    patch.triangles = std::move(triangles);
    const std::size_t corners = 3 * patch.triangles.size();
    for(std::size_t t = 0; t < patch.triangles.size(); ++t)
      m_local[patch.triangles[t]] = static_cast<int>(t);
    patch.chart.scale = m_whole.scale;
    patch.chart.opposite.assign(corners, -1);
    patch.chart.seam.assign(corners, -1);
    for(int c = 0; c < static_cast<int>(corners); ++c) {
      const int whole_corner = patch.whole_corner(c), across = m_whole.opposite[whole_corner];
      patch.cost.push_back(m_cost[whole_corner]);
      if(across >= 0 && !is_seam[whole_corner])
        patch.chart.opposite[c] = local_corner(across);
      else
        patch.chart.seam[c] =
            local_corner(across >= 0 || m_whole.seam.empty() ? across : m_whole.seam[whole_corner]);
    }
    for(int t : patch.triangles)
      m_local[t] = -1;
    number_vertices(patch);
    return patch;
  }

private:
  // In the patch, or -1
  int local_corner(int whole_corner) const
  {
    const int t = whole_corner < 0 ? -1 : m_local[whole_corner / 3];
    return t < 0 ? -1 : 3 * t + whole_corner % 3;
  }

  void number_vertices(Dual_patch& patch) const
  {
    Chart& chart = patch.chart;
    chart.vertex.assign(chart.opposite.size(), -1);
    for(int c = 0; c < chart.number_of_corners(); ++c)
      if(chart.vertex[c] < 0) {
        const int v = m_whole.vertex[patch.whole_corner(c)];
        for(int around : corners_around(chart, c))
          chart.vertex[around] = chart.number_of_vertices();
        chart.points.push_back(m_whole.points[v]);
        patch.origin.push_back(v);
      }
    find_borders(chart);
  }

  const Chart& m_whole;
  const std::vector<double>& m_cost;
  std::vector<int> m_local; // of each triangle: its number in the patch, or -1
};

// The triangles of a patch in connected parts, across edges with `is_crossed(corner)`, as a number for each from 0 on
template <typename IsCrossed>
std::vector<int> connected_triangles(const Chart& patch, const IsCrossed& is_crossed)
{
  const int n = patch.number_of_triangles();
  Disjoint_sets sets(static_cast<std::size_t>(n));
  for(int c = 0; c < patch.number_of_corners(); ++c)
    if(patch.opposite[c] > c && is_crossed(c))
      sets.union_set(c / 3, patch.opposite[c] / 3);
  std::vector<int> number(n, -1), result(n);
  int count = 0;
  for(int t = 0; t < n; ++t) {
    int& part = number[sets.find_set(t)];
    if(part < 0)
      part = count++;
    result[t] = part;
  }
  return result;
}

// Triangles that no seam can separate have the same number: what is between them must not become a seam.
inline std::vector<int> inseparable_triangles(const Dual_patch& patch)
{
  return connected_triangles(patch.chart, [&](int c) { return std::isinf(patch.cost[c]); });
}

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
