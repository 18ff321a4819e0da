// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The border of a map while its vertices move, with exact tests whether it is simple, and a tree of boxes that finds
// edges nearby. `border_barrier.h` tests single moves with it, and finds its pairs; `injective_descent.h` tests whole
// steps. If triangles are positively oriented, a simple border makes the map of a disk injective (Lipman 2014).

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_PLANAR_BORDER_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_PLANAR_BORDER_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/border_sweep.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <limits>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// An axis-parallel box, empty by default
struct Planar_box
{
  Planar_point low = Planar_point::Constant((std::numeric_limits<double>::infinity)());
  Planar_point high = -low;

  Planar_box() = default;
  Planar_box(const Planar_point& p, const Planar_point& q) : low(p.cwiseMin(q)), high(p.cwiseMax(q)) {}

  Planar_box widened(double margin) const
  {
    Planar_box box = *this;
    box.low.array() -= margin;
    box.high.array() += margin;
    return box;
  }

  bool meets(const Planar_box& other) const
  {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }

  friend Planar_box operator+(const Planar_box& a, const Planar_box& b)
  {
    Planar_box sum;
    sum.low = a.low.cwiseMin(b.low);
    sum.high = a.high.cwiseMax(b.high);
    return sum;
  }
};

// A binary tree of boxes over a sequence of boxes, of which neighbours are near one another. It takes edges of all
// lengths, which a grid does not. One box changes in `O(log n)` time.
class Box_tree
{
public:
  // `box(i)` is the box with number i.
  template <typename Box>
  void build(int n, const Box& box)
  {
    for(m_leaves = 1; m_leaves < n;)
      m_leaves *= 2;
    m_nodes.assign(2 * m_leaves, Planar_box());
    for(int i = 0; i < n; ++i)
      m_nodes[m_leaves + i] = box(i);
    for(int i = m_leaves - 1; i > 0; --i)
      m_nodes[i] = m_nodes[2 * i] + m_nodes[2 * i + 1];
  }

  void set(int i, const Planar_box& box)
  {
    m_nodes[i += m_leaves] = box;
    while(i /= 2)
      m_nodes[i] = m_nodes[2 * i] + m_nodes[2 * i + 1];
  }

  // Calls `visit(i)` for each box that meets `box`, in ascending order, until it returns `false`.
  template <typename Visitor>
  bool for_each_at(const Planar_box& box, const Visitor& visit) const
  {
    return for_each_at(1, box, visit);
  }

private:
  template <typename Visitor>
  bool for_each_at(int node, const Planar_box& box, const Visitor& visit) const
  {
    if(!m_nodes[node].meets(box))
      return true;
    if(node >= m_leaves)
      return visit(node - m_leaves);
    return for_each_at(2 * node, box, visit) && for_each_at(2 * node + 1, box, visit);
  }

  int m_leaves = 1;
  std::vector<Planar_box> m_nodes = std::vector<Planar_box>(2); // the children of node i are 2 i and 2 i + 1
};

// The borders of a chart in the plane, while their vertices move one by one: whether edges touch, and which are near. A
// disk whose triangles are all positively oriented is injective if its border is simple, so nothing else needs a test.
//
// Vertices and edges have numbers along the cycles; an edge has that of its source.
class Planar_border
{
public:
  Planar_border() = default;
  Planar_border(const Border_cycles& cycles, const std::vector<Planar_point>& uv) { set(cycles, uv); }

  // Takes other borders, into the memory of the last ones.
  void set(const Border_cycles& cycles, const std::vector<Planar_point>& uv)
  {
    m_vertices.clear();
    m_previous.clear();
    m_edges.clear();
    m_number.assign(uv.size(), -1);
    for(const std::vector<int>& cycle : cycles) {
      const int begin = static_cast<int>(m_vertices.size()), size = static_cast<int>(cycle.size());
      for(int i = 0; i < size; ++i) {
        m_number[cycle[i]] = begin + i;
        m_edges.push_back({begin + i, begin + (i + 1) % size});
        m_previous.push_back(begin + (i + size - 1) % size);
      }
      m_vertices.insert(m_vertices.end(), cycle.begin(), cycle.end());
    }
    m_points.resize(m_vertices.size());
    m_taken_length.resize(m_vertices.size());
    take(uv);
  }

  int size() const { return static_cast<int>(m_vertices.size()); }
  int vertex(int i) const { return m_vertices[i]; }
  int number(int v) const { return m_number[v]; } // negative if `v` is interior
  int next(int i) const { return m_edges[i].target; }
  int previous(int i) const { return m_previous[i]; }
  Planar_point point(int i) const { return Planar_point(m_points[i].x(), m_points[i].y()); }
  double edge_length(int i) const { return (point(next(i)) - point(i)).norm(); }

  // The length of edge i, and the mean length of the edges at vertex i, when all positions were taken last
  double taken_length(int i) const { return m_taken_length[i]; }
  double local_length(int i) const { return (taken_length(i) + taken_length(previous(i))) / 2; }

  // Takes the positions of all vertices, and the local lengths.
  void take(const std::vector<Planar_point>& uv)
  {
    move_all(uv);
    for(int i = 0; i < size(); ++i)
      m_taken_length[i] = edge_length(i);
  }

  void move_all(const std::vector<Planar_point>& uv)
  {
    for(int i = 0; i < size(); ++i)
      set_point(i, uv[m_vertices[i]]);
    m_tree.build(size(), [this](int i) { return edge_box(i); });
  }

  void move(int i, const Planar_point& p)
  {
    set_point(i, p);
    m_tree.set(i, edge_box(i));
    m_tree.set(previous(i), edge_box(previous(i)));
  }

  // Whether an edge at vertex i has a point in common with another edge, other than a vertex of both. Exact.
  bool touches_at(int i) const { return edge_touches(i) || edge_touches(previous(i)); }

  // Whether no edges touch, holes are within the outer border and apart. Exact.
  bool is_simple() const { return bounds_region(m_edges, m_points); }

  // Calls `visit` with the number of each edge whose box meets `box`.
  template <typename Visitor>
  void for_each_edge_at(const Planar_box& box, const Visitor& visit) const
  {
    m_tree.for_each_at(box, [&](int i) {
      visit(i);
      return true;
    });
  }

private:
  void set_point(int i, const Planar_point& p) { m_points[i] = Exact_point_2(p.x(), p.y()); }

  Planar_box edge_box(int i) const { return Planar_box(point(i), point(next(i))); }

  bool edge_touches(int i) const
  {
    return !m_tree.for_each_at(edge_box(i),
                               [&](int j) { return i == j || !touch(m_edges[i], m_edges[j], m_points); });
  }

  std::vector<int> m_vertices, m_previous;
  std::vector<int> m_number; // of each vertex of the chart
  std::vector<Border_edge> m_edges;
  std::vector<Exact_point_2> m_points;
  std::vector<double> m_taken_length;
  Box_tree m_tree;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_PLANAR_BORDER_H
