// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Half-edge collapses of a corner table that can be undone (Section 5.1), each remembered by a single number.
// `coarsening_stage.h` collapses and undoes with it. Stars read the connectivity of the present level from it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_EDGE_COLLAPSES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_EDGE_COLLAPSES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/chart.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>

#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The connectivity of a chart, which half-edge collapses make coarser. Undoing them in reverse order makes it finer
// again. A collapse merges a vertex into a neighbour, which does not move. The entries of the triangles that vanish
// are kept, so a single number is enough to undo a collapse.
class Edge_collapses
{
public:
  // `c` is a corner at the vertex that vanishes, if the edge to the vertex of the next corner is collapsed. `~c`
  // means the edge to the vertex of the previous corner, where only that edge is on the border.
  typedef int Record;

  explicit Edge_collapses(Chart& chart) : m_chart(chart), m_corner_at(chart.points.size(), -1)
  {
    for(int c = 0; c < chart.number_of_corners(); ++c)
      m_corner_at[chart.vertex[c]] = c;
  }

  const Chart& chart() const { return m_chart; }
  const std::vector<Record>& records() const { return m_records; }
  bool is_alive(int v) const { return m_corner_at[v] >= 0; }

  static int corner(Record record) { return record < 0 ? ~record : record; }
  int removed_vertex(Record record) const { return m_chart.vertex[corner(record)]; }
  int kept_vertex(Record record) const
  {
    return m_chart.vertex[record < 0 ? previous_corner(~record) : next_corner(record)];
  }

  // The triangles that have not vanished, sorted
  std::vector<int> remaining_triangles() const
  {
    std::vector<char> is_there(m_chart.number_of_triangles(), true);
    for(Record record : m_records)
      for_each_vanishing(record,
                         [&](const Vanishing& triangle) { is_there[triangle.removed_corner / 3] = false; });
    std::vector<int> triangles;
    triangles.reserve(is_there.size());
    for(int t = 0; t < m_chart.number_of_triangles(); ++t)
      if(is_there[t])
        triangles.push_back(t);
    return triangles;
  }

  // The next corner counterclockwise around the vertex of `c`, or -1 after the last triangle.
  int rotate_back(int c) const
  {
    const int across = m_chart.opposite[next_corner(c)];
    return across < 0 ? -1 : next_corner(across);
  }

  // The corner at `v` of the first triangle in clockwise order, or of any triangle if `v` is interior.
  int first_corner(int v) const
  {
    const int start = m_corner_at[v];
    if(m_chart.interior[v] >= 0)
      return start;
    int first = start;
    for(int c = rotate_back(start); c >= 0; c = rotate_back(c))
      first = c;
    return first;
  }

  // Calls `visit` with the corner at `v` of each triangle, clockwise.
  template <typename Visitor>
  void for_each_corner(int v, const Visitor& visit) const
  {
    const int first = first_corner(v);
    int c = first;
    do {
      const int next = m_chart.rotate(c);
      visit(c);
      c = next;
    } while(c >= 0 && c != first);
  }

  void collapse(Record record)
  {
    const int v = removed_vertex(record), w = kept_vertex(record);
    relabel(record, w);
    for_each_vanishing(record, [&](const Vanishing& triangle) {
      glue(triangle.outer_of_kept, triangle.outer_of_removed);
      move_corners_off(triangle, w);
    });
    m_corner_at[v] = -1;
    m_records.push_back(record);
  }

  // Undoes the last collapse that has not been undone. Returns the vertex that it had removed.
  int undo()
  {
    const Record record = m_records.back();
    m_records.pop_back();
    const int v = removed_vertex(record), w = kept_vertex(record);
    for_each_vanishing(record, [&](const Vanishing& triangle) {
      if(triangle.outer_of_removed >= 0)
        m_chart.opposite[triangle.outer_of_removed] = triangle.kept_corner;
      if(triangle.outer_of_kept >= 0)
        m_chart.opposite[triangle.outer_of_kept] = triangle.removed_corner;
    });
    relabel(record, v);
    m_corner_at[v] = corner(record);
    m_corner_at[w] = record < 0 ? previous_corner(~record) : next_corner(record);
    return v;
  }

private:
  // A triangle at the collapsed edge: its corners at the two vertices of the edge, and the corners behind its two
  // other edges. (The edge at the removed vertex is the one that faces the corner at the kept one.)
  struct Vanishing
  {
    int removed_corner, kept_corner, third_corner;
    int outer_of_removed, outer_of_kept;
  };

  Vanishing vanishing(int removed_corner, int kept_corner) const
  {
    return {removed_corner, kept_corner, 9 * (removed_corner / 3) + 3 - removed_corner - kept_corner,
            m_chart.opposite[kept_corner], m_chart.opposite[removed_corner]};
  }

  template <typename Visitor>
  void for_each_vanishing(Record record, const Visitor& visit) const
  {
    const int c = corner(record);
    const int kept = record < 0 ? previous_corner(c) : next_corner(c);
    const int facing = record < 0 ? next_corner(c) : previous_corner(c);
    const int across = m_chart.opposite[facing];
    visit(vanishing(c, kept));
    if(across >= 0)
      visit(vanishing(previous_corner(across), next_corner(across)));
  }

  // Assigns the corners at the removed vertex in the remaining triangles to vertex `v`.
  void relabel(Record record, int v)
  {
    if(record < 0) {
      for(int c = m_chart.rotate(~record); c >= 0; c = m_chart.rotate(c))
        m_chart.vertex[c] = v;
      return;
    }
    const int across = m_chart.opposite[previous_corner(record)];
    const int end = across < 0 ? -1 : previous_corner(across);
    for(int c = rotate_back(record); c != end; c = rotate_back(c))
      m_chart.vertex[c] = v;
  }

  void glue(int c, int d)
  {
    if(c >= 0)
      m_chart.opposite[c] = d;
    if(d >= 0)
      m_chart.opposite[d] = c;
  }

  // Makes the vertices of a vanishing triangle refer to a corner of a remaining triangle.
  void move_corners_off(const Vanishing& triangle, int kept)
  {
    const int outer = triangle.outer_of_kept >= 0 ? triangle.outer_of_kept : triangle.outer_of_removed;
    const int third = m_chart.vertex[triangle.third_corner];
    for(int c : {next_corner(outer), previous_corner(outer)})
      m_corner_at[m_chart.vertex[c] == third ? third : kept] = c;
  }

  Chart& m_chart;
  std::vector<int> m_corner_at; // one corner at each remaining vertex
  std::vector<Record> m_records;
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_MULTIRESOLUTION_EDGE_COLLAPSES_H
