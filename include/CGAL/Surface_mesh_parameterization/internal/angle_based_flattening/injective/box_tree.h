// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A tree of bounding boxes that finds edges near a given box, and follows single edges that move.
// `planar_border.h` keeps the edges of the border in it, so that a test of one edge does not look at all others.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BOX_TREE_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BOX_TREE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/angles/planar_angle.h>

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

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_INJECTIVE_BOX_TREE_H
