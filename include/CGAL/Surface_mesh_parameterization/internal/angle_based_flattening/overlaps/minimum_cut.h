// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The cheapest seam between two sheets of a map that overlap, as a minimum cut of the dual graph. `separate_overlaps.h`
// makes one such cut after the other. The paper splits its charts by Sheffer and Hart (2002) instead.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_OVERLAPS_MINIMUM_CUT_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_OVERLAPS_MINIMUM_CUT_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/overlaps/dual_patch.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/overlaps/sheets.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The cheapest cut of a patch between two sheets, as a maximum flow on its dual graph. Each sheet is one node, and so
// is each block of triangles that must not be separated.
class Minimum_cut
{
  typedef boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                             boost::no_property, int, int>
      Graph;
  typedef boost::graph_traits<Graph>::edge_descriptor Edge;

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
  enum
  {
    SOURCE,
    SINK
  };

  void number_nodes(const std::vector<Sheet>& sheet, const std::vector<int>& block)
  {
    std::vector<int> node_of_block(block.size(), -1);
    m_number_of_nodes = 2;
    for(std::size_t t = 0; t < block.size(); ++t) {
      int& node = node_of_block[block[t]];
      if(node < 0)
        node = sheet[t] == Sheet::FIRST    ? static_cast<int>(SOURCE)
               : sheet[t] == Sheet::SECOND ? static_cast<int>(SINK)
                                           : m_number_of_nodes++;
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

    std::vector<std::pair<int, int>> edges;
    std::vector<int> rank(opposite.size(), -1);
    std::vector<double> capacity;
    for(int c : corners) {
      rank[c] = static_cast<int>(edges.size());
      edges.emplace_back(node(c), node(opposite[c]));
      capacity.push_back(m_patch.cost[c]);
    }
    const Graph graph(boost::edges_are_sorted, edges.begin(), edges.end(), m_number_of_nodes);
    std::vector<Edge> reverse;
    for(int c : corners)
      reverse.emplace_back(node(opposite[c]), rank[opposite[c]]);
    run(graph, capacity, reverse);
  }

  void run(const Graph& graph, const std::vector<double>& capacity, const std::vector<Edge>& reverse)
  {
    const auto node_index = get(boost::vertex_index, graph);
    const auto edge_index = get(boost::edge_index, graph);
    std::vector<double> residual(capacity.size());
    std::vector<Edge> predecessor(m_number_of_nodes);
    std::vector<boost::default_color_type> color(m_number_of_nodes);
    std::vector<int> distance(m_number_of_nodes);
    boost::boykov_kolmogorov_max_flow(graph, boost::make_iterator_property_map(capacity.begin(), edge_index),
                                      boost::make_iterator_property_map(residual.begin(), edge_index),
                                      boost::make_iterator_property_map(reverse.begin(), edge_index),
                                      boost::make_iterator_property_map(predecessor.begin(), node_index),
                                      boost::make_iterator_property_map(color.begin(), node_index),
                                      boost::make_iterator_property_map(distance.begin(), node_index),
                                      node_index, static_cast<int>(SOURCE), static_cast<int>(SINK));
    for(boost::default_color_type c : color) // black is what the flow can still reach from the source
      m_on_first_side.push_back(c == boost::black_color);
  }

  const Dual_patch& m_patch;
  int m_number_of_nodes = 0;
  std::vector<int> m_node; // of each triangle
  std::vector<char> m_on_first_side;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_OVERLAPS_MINIMUM_CUT_H
