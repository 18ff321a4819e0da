// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The maximum flow through a network, by Boost. `angle_flow.h` and `minimum_cut.h` call it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_MAXIMUM_FLOW_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_MAXIMUM_FLOW_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Its edges are sorted by their sources.
struct Flow_network
{
  enum Node
  {
    SOURCE,
    SINK,
    FIRST_OTHER
  };

  int number_of_nodes = FIRST_OTHER;
  std::vector<std::pair<int, int>> edges; // from node to node
  std::vector<double> capacity;           // of each edge
  std::vector<int> reverse;               // of each edge: the one in the other direction
};

struct Maximum_flow
{
  double value = 0;
  std::vector<char> is_reached; // of each node: whether more can flow to it from the source
};

inline Maximum_flow maximum_flow(const Flow_network& network)
{
  typedef boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, boost::no_property,
                                             boost::no_property, int, int>
      Graph;
  typedef boost::graph_traits<Graph>::edge_descriptor Edge;
  const int n = network.number_of_nodes;
  const Graph graph(boost::edges_are_sorted, network.edges.begin(), network.edges.end(), n);
  std::vector<Edge> reverse;
  for(std::size_t e = 0; e < network.edges.size(); ++e)
    reverse.emplace_back(network.edges[e].second, network.reverse[e]);
  const auto node_index = get(boost::vertex_index, graph);
  const auto edge_index = get(boost::edge_index, graph);
  std::vector<double> residual(network.capacity.size());
  std::vector<Edge> predecessor(n);
  std::vector<boost::default_color_type> color(n);
  std::vector<int> distance(n);
  Maximum_flow result;
  result.value = boost::boykov_kolmogorov_max_flow(
      graph, boost::make_iterator_property_map(network.capacity.begin(), edge_index),
      boost::make_iterator_property_map(residual.begin(), edge_index),
      boost::make_iterator_property_map(reverse.begin(), edge_index),
      boost::make_iterator_property_map(predecessor.begin(), node_index),
      boost::make_iterator_property_map(color.begin(), node_index),
      boost::make_iterator_property_map(distance.begin(), node_index), node_index,
      static_cast<int>(Flow_network::SOURCE), static_cast<int>(Flow_network::SINK));
  for(boost::default_color_type c : color)
    result.is_reached.push_back(c == boost::black_color);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_MAXIMUM_FLOW_H
