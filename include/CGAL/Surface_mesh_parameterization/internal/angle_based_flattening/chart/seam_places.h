// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Tells which vertices of a cut chart were one vertex of the surface before.
// Equations and angles at seams (`seam_nodes.h`, `set_angle_sums.h`) and the report of `border_shape.h` rely on it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SEAM_PLACES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SEAM_PLACES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/Disjoint_sets.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>

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

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_SEAM_PLACES_H
