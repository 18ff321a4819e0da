// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The equations of the surface before it was cut: Eqs. 3 and 4 around vertices of seams, and loops where these are not
// enough. `find_nodes()` in `find_borders.h` calls it, by a pointer, for charts whose seams have equal sides; the paper
// leaves seams free.
//
// Tells which vertices of a cut chart were one vertex of the surface before.
// Equations and angles at seams (`seam_nodes.h`, `check_surface_sums.h`) and the report of `border_shape.h` rely on it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SEAM_NODES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SEAM_NODES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The vertices of the surface before it was cut along the seams of the outer border, here called places. A place is
// named by one of the vertices of the chart that are its copies. Seams with a side on a hole count as borders of the
// surface.
class Seam_places
{
public:
  explicit Seam_places(const Chart& chart)
      : m_chart(chart), m_is_outer(chart.vertex.size(), false), m_is_on_seam(chart.points.size(), false),
        m_is_on_border(chart.points.size(), false), m_copies(chart.points.size(), 0)
  {
    for(int c : chart.borders.front())
      m_is_outer[c] = true;
    find_places();
    for(int c : chart.borders.front()) {
      ++m_copies[of(chart.edge_source(c))];
      for(int v : {chart.edge_source(c), chart.edge_target(c)})
        (across(c) >= 0 ? m_is_on_seam : m_is_on_border)[of(v)] = true;
      m_is_closed = m_is_closed && across(c) >= 0;
    }
  }

  // The corner that faces the other side of a seam on the outer border, or -1
  int across(int c) const
  {
    const int other = c < static_cast<int>(m_chart.seam.size()) ? m_chart.seam[c] : -1;
    return other >= 0 && m_is_outer[c] && m_is_outer[other] ? other : -1;
  }

  int of(int v) const { return m_place[v]; }
  const std::vector<int>& of_vertices() const { return m_place; }
  int copies(int place) const { return m_copies[place]; } // on the outer border

  // Whether a place is on a seam, and the triangles close around it
  bool is_inside(int place) const { return m_is_on_seam[place] && !m_is_on_border[place]; }

  bool has_seams() const
  {
    for(int c : m_chart.borders.front())
      if(across(c) >= 0)
        return true;
    return false;
  }

  // Whether the surface has no border but holes
  bool is_closed() const { return m_is_closed; }

private:
  void find_places()
  {
    Disjoint_sets sets(m_chart.points.size());
    for(int c : m_chart.borders.front())
      if(const int other = across(c); other >= 0) {
        sets.union_set(m_chart.edge_source(c), m_chart.edge_target(other));
        sets.union_set(m_chart.edge_target(c), m_chart.edge_source(other));
      }
    for(int v = 0; v < m_chart.number_of_vertices(); ++v)
      m_place.push_back(static_cast<int>(sets.find_set(v)));
  }

  const Chart& m_chart;
  std::vector<char> m_is_outer; // of each corner: whether it faces an edge of the outer border
  std::vector<int> m_place;     // of each vertex
  std::vector<char> m_is_on_seam, m_is_on_border;
  std::vector<int> m_copies;
  bool m_is_closed = true;
};

// Makes the constraint nodes of seams of equal sides: equations of the surface before the cut. Inside of that surface,
// triangles close around the vertices of seams, and so these have the equation for lengths (Eq. 4), and that for angles
// (Eq. 3) if sums are prescribed.
class Seam_nodes
{
public:
  explicit Seam_nodes(Chart& chart) : m_chart(chart), m_places(chart) {}

  void add()
  {
    add_nodes();
    drop_implied_equations();
    m_chart.crossings.clear();
    m_chart.number_of_loops = 0;
    add_loops();
    std::stable_sort(
        m_chart.crossings.begin(), m_chart.crossings.end(),
        [](const Loop_crossing& a, const Loop_crossing& b) { return a.triangle() < b.triangle(); });
  }

private:
  Constraint_node node_of(int v) const
  {
    Constraint_node node = {0, false, m_places.is_inside(m_places.of(v))};
    if(m_chart.surface_sums.empty())
      return node;
    const double sum = m_chart.surface_sums[v];
    node.has_planarity = std::isnan(sum) ? node.has_reconstruction : std::isfinite(sum);
    if(node.has_planarity)
      node.angle_sum = std::isnan(sum) ? 2 * pi : sum;
    return node;
  }

  void add_nodes()
  {
    m_first = m_chart.number_of_nodes();
    std::vector<int> node_of_place(m_chart.points.size(), -1);
    for(int c : m_chart.borders.front()) {
      const int v = m_chart.edge_source(c);
      int& node = node_of_place[m_places.of(v)];
      if(node < 0) {
        const Constraint_node equations = node_of(v);
        m_is_every_sum_prescribed = m_is_every_sum_prescribed && equations.has_planarity;
        if(!equations.has_planarity && !equations.has_reconstruction)
          continue;
        node = m_chart.number_of_nodes();
        m_chart.nodes.push_back(equations);
      }
      m_chart.node[v] = node;
    }
  }

  // On a closed surface, one equation for lengths follows from all others. So does one equation for angles if none is
  // missing, because the equations of triangles give their total.
  void drop_implied_equations()
  {
    if(m_places.is_closed())
      m_chart.nodes.back().has_reconstruction = false;
    if(m_is_every_sum_prescribed)
      m_chart.nodes[m_first].has_planarity = false;
  }

  // With the equations around vertices, the change of lengths across seams obeys Kirchhoff's law at interior vertices.
  // If it vanishes on all edges outside of a spanning tree, it vanishes on all edges. All borders are one vertex of the
  // tree.
  void add_loops()
  {
    const int border = m_chart.number_of_vertices();
    Disjoint_sets trees(m_chart.points.size() + 1);
    const auto vertex = [&](int v) {
      const int place = m_places.of(v);
      return static_cast<int>(trees.find_set(m_places.is_inside(place) ? place : border));
    };
    for(int c : m_chart.borders.front())
      if(const int other = m_places.across(c); other > c) {
        const int a = vertex(m_chart.edge_source(c)), b = vertex(m_chart.edge_target(c));
        if(a == b)
          add_loop(c, other);
        else
          trees.union_set(a, b);
      }
  }

  // The shortest way from one side of a seam to the other one, across the edges of triangles
  void add_loop(int from, int to)
  {
    std::vector<int> entry(m_chart.number_of_triangles(),
                           -1); // the corner that faces the edge to the triangle before
    std::vector<int> queue{from / 3};
    entry[from / 3] = from;
    for(std::size_t i = 0; entry[to / 3] < 0; ++i)
      for(int c = 3 * queue[i]; c < 3 * queue[i] + 3; ++c)
        if(const int across = m_chart.opposite[c]; across >= 0 && entry[across / 3] < 0) {
          entry[across / 3] = across;
          queue.push_back(across / 3);
        }
    for(int out = to;; out = m_chart.opposite[entry[out / 3]]) {
      m_chart.crossings.push_back({entry[out / 3], out, m_chart.number_of_loops});
      if(out / 3 == from / 3)
        break;
    }
    ++m_chart.number_of_loops;
    m_chart.nodes.push_back({0, false, true});
  }

  Chart& m_chart;
  const Seam_places m_places;
  int m_first = 0;
  bool m_is_every_sum_prescribed = true;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SEAM_NODES_H
