// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A maximum flow that tells whether planar angles with prescribed sums exist, and if not, at which vertices the
// conflict is. The last test of `check_angle_sums.h` and `check_surface_sums.h`, where no simpler reason was found.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_ANGLE_FLOW_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_ANGLE_FLOW_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/maximum_flow.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/target_angles.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// Planar angles exist if each of them can be this large.
inline constexpr double least_angle_of_flow = 1e-6;

// Whether each triangle can give pi to its three corners so that interior vertices get 2 pi, and others what is
// prescribed: a maximum flow from triangles to vertices, all others being one vertex. It starts near the target angles.
class Angle_flow
{
public:
  // `place` names the copies of a vertex by one of them, and `sums` has the prescribed sum of each place, or NaN.
  Angle_flow(const Chart& chart, const std::vector<int>& place, const std::vector<double>& sums)
      : m_chart(chart), m_first_vertex(Flow_network::FIRST_OTHER + chart.number_of_triangles()),
        m_node(chart.points.size()), m_supply(chart.number_of_triangles(), pi - 3 * least_angle_of_flow)
  {
    find_demands(place, sums);
    find_first_flow();
    find_maximum_flow();
  }

  bool is_feasible() const { return m_missing <= least_angle_of_flow / 2; }

  // If the sums are not possible: whether those of some vertices in conflict are too large, or else too small; and
  // whether a vertex is in conflict
  bool is_too_large() const { return !m_has_others || is_reached(m_others); }
  bool is_in_conflict(int v) const { return is_reached(m_node[v]) != is_too_large(); }

private:
  bool is_reached(int node) const { return m_is_reached[node]; }
  int node_of_triangle(int t) const { return Flow_network::FIRST_OTHER + t; }
  int rank(int corner) const { return m_node[m_chart.vertex[corner]] - m_first_vertex; }

  void find_demands(const std::vector<int>& place, const std::vector<double>& sums)
  {
    double others = 0;
    for(int v = 0; v < m_chart.number_of_vertices(); ++v) {
      const double sum = m_chart.interior[v] >= 0 ? 2 * pi : sums[v];
      m_node[v] = -1;
      if(place[v] != v || std::isnan(sum))
        continue;
      m_node[v] = m_first_vertex + static_cast<int>(m_demand.size());
      m_demand.push_back(sum);
      others -= sum;
    }
    for(int v = 0; v < m_chart.number_of_vertices(); ++v)
      m_node[v] = m_node[place[v]];
    m_others = m_first_vertex + static_cast<int>(m_demand.size());
    std::replace(m_node.begin(), m_node.end(), -1, m_others);
    m_demand.push_back(others + pi * m_chart.number_of_triangles());
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      m_demand[rank(c)] -= least_angle_of_flow;
    m_has_others = std::find(m_node.begin(), m_node.end(), m_others) != m_node.end();
    if(!m_has_others)
      m_demand.back() = 0; // but for rounding
  }

  // As much of the target angles as triangles and vertices allow
  void find_first_flow()
  {
    const std::vector<double> beta = target_angles(m_chart);
    std::vector<double> sum(m_demand.size(), 0.);
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      sum[rank(c)] += beta[c];
    for(int c = 0; c < m_chart.number_of_corners(); ++c) {
      const int first = 3 * (c / 3);
      const double of_triangle = beta[first] + beta[first + 1] + beta[first + 2];
      m_flow.push_back((std::min)(beta[c] / sum[rank(c)] * (std::max)(m_demand[rank(c)], 0.),
                                  beta[c] / of_triangle * (pi - 3 * least_angle_of_flow)));
    }
    for(int c = 0; c < m_chart.number_of_corners(); ++c) {
      m_supply[c / 3] -= m_flow[c];
      m_demand[rank(c)] -= m_flow[c];
    }
  }

  // An edge of the network with the capacities in both directions
  struct Pipe
  {
    int source, target;
    double capacity, reverse_capacity;
  };

  std::vector<Pipe> pipes() const
  {
    const double unlimited = pi * m_chart.number_of_triangles();
    std::vector<Pipe> result;
    for(int t = 0; t < m_chart.number_of_triangles(); ++t)
      result.push_back({Flow_network::SOURCE, node_of_triangle(t), (std::max)(m_supply[t], 0.), 0});
    for(std::size_t i = 0; i < m_demand.size(); ++i)
      result.push_back(
          {m_first_vertex + static_cast<int>(i), Flow_network::SINK, (std::max)(m_demand[i], 0.), 0});
    for(int c = 0; c < m_chart.number_of_corners(); ++c)
      result.push_back({node_of_triangle(c / 3), m_first_vertex + rank(c), unlimited, m_flow[c]});
    return result;
  }

  void find_maximum_flow()
  {
    const std::vector<Pipe> all = pipes();
    const int n = static_cast<int>(all.size());
    // Edge 2 i is pipe i, and edge 2 i + 1 its reverse.
    const auto source = [&](int e) { return e % 2 == 0 ? all[e / 2].source : all[e / 2].target; };
    const auto target = [&](int e) { return e % 2 == 0 ? all[e / 2].target : all[e / 2].source; };
    std::vector<int> order(2 * n), place(2 * n);
    for(int e = 0; e < 2 * n; ++e)
      order[e] = e;
    std::stable_sort(order.begin(), order.end(), [&](int e, int f) { return source(e) < source(f); });
    Flow_network network;
    network.number_of_nodes = m_others + 1;
    for(int e : order) {
      place[e] = static_cast<int>(network.edges.size());
      network.edges.emplace_back(source(e), target(e));
      network.capacity.push_back(e % 2 == 0 ? all[e / 2].capacity : all[e / 2].reverse_capacity);
    }
    for(int e : order)
      network.reverse.push_back(place[e ^ 1]);
    Maximum_flow flow = maximum_flow(network);
    m_missing = -flow.value;
    for(double demand : m_demand)
      m_missing += (std::max)(demand, 0.);
    m_is_reached = std::move(flow.is_reached);
  }

  const Chart& m_chart;
  int m_first_vertex, m_others = 0; // nodes: the first one of a vertex, and the one of all other vertices
  bool m_has_others = false;
  std::vector<int> m_node;                // of each vertex
  std::vector<double> m_supply, m_demand; // what is left of them
  std::vector<double> m_flow;             // the first one
  double m_missing = 0;
  std::vector<char> m_is_reached; // of each node: whether more can flow to it
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_ANGLES_ANGLE_FLOW_H
