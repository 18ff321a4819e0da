// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// From the faces of a mesh to a corner table, in the order of a breadth-first search, so that neighbours are close in
// memory. `read_chart.h` and `read_surface.h` read with it, and number the vertices.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FACE_SEARCH_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FACE_SEARCH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/corner_table.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/diagnose.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

template <typename Point>
Corner_table::Point_3 point_in_doubles(const Point& p)
{
  return Corner_table::Point_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

// The faces that a breadth-first search over a mesh has found, in its order, so that neighbours are near to each other
// in memory. They are the triangles of a corner table: the corners are at the targets of the halfedge by which the
// search entered the face, of the next one, and of the one after that. The second one faces the entry.
template <typename TriangleMesh>
class Face_search
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int>>::const_type Ranks;

public:
  explicit Face_search(const TriangleMesh& mesh) : m_mesh(mesh) {}

  // Begins a search. Returns the largest possible number of faces: that of the mesh.
  std::size_t begin()
  {
    std::size_t number = 0;
    m_ranks = get(CGAL::dynamic_face_property_t<int>(), m_mesh);
    for(face_descriptor f : faces(m_mesh)) {
      put(m_ranks, f, -1);
      ++number;
    }
    m_entries.reserve(number);
    return number;
  }

  // Returns the memory of the ranks, when they are not asked for any more.
  void forget_ranks() { m_ranks = Ranks(); }

  int size() const { return static_cast<int>(m_entries.size()); }

  // The triangle that a face is, negative if it was not found
  int rank(face_descriptor f) const { return get(m_ranks, f); }
  face_descriptor face_of(int t) const { return face(m_entries[t], m_mesh); }
  halfedge_descriptor entry(int t) const { return m_entries[t]; }

  // Finds the faces that are connected with that of `entry`, but for the edges with `is_cut(e)`, and makes them the
  // triangles of `table`: sets `opposite`, and `seam` along cut edges. Calls `enter(from)` when it comes upon a face,
  // across the edge that corner `from` faces, -1 for the first one, and `visit(t)` before it looks for the neighbours
  // of face t.
  template <typename IsCut, typename Enter, typename Visit>
  Chart_defect find_part(halfedge_descriptor entry, const IsCut& is_cut, const Enter& enter,
                         const Visit& visit, Corner_table& table)
  {
    const int first = size();
    const auto link_across = [&](halfedge_descriptor h, int corner) {
      link(h, corner, first, is_cut, enter, table);
    };
    add(entry, -1, enter, table);
    for(int t = first; t < size(); ++t) {
      if(!is_triangle(t))
        return {Diagnosis::NOT_TRIANGULATED, "a face is not a triangle", {}, {t}};
      visit(t);
      if(t == first)
        link_across(entry, 1);
      link_others(t, t - first, link_across);
      if(size() > largest_number_of_triangles)
        return {Diagnosis::TOO_LARGE, "the surface has more triangles than 32-bit numbers allow", {}, {}};
    }
    if(!table.seam.empty())
      table.seam.resize(table.opposite.size(), -1);
    return {};
  }

  halfedge_descriptor halfedge_to(int corner) const
  {
    const halfedge_descriptor entry = m_entries[corner / 3];
    return corner % 3 == 0 ? entry : corner % 3 == 1 ? next(entry, m_mesh) : prev(entry, m_mesh);
  }

  halfedge_descriptor faced_halfedge(int corner) const
  {
    const halfedge_descriptor entry = m_entries[corner / 3];
    return corner % 3 == 0 ? prev(entry, m_mesh) : corner % 3 == 1 ? entry : next(entry, m_mesh);
  }

  // Which corner of triangle `t` faces its halfedge `h`: 0, 1 or 2
  int facing_corner(halfedge_descriptor h, int t) const
  {
    return h == m_entries[t] ? 1 : next(h, m_mesh) == m_entries[t] ? 0 : 2;
  }

private:
  bool is_triangle(int t) const
  {
    const halfedge_descriptor second = next(m_entries[t], m_mesh);
    return second != m_entries[t] && next(next(second, m_mesh), m_mesh) == m_entries[t];
  }

  // Adds the face of `entry`, which corner `from` faces from the other side.
  template <typename Enter>
  void add(halfedge_descriptor entry, int from, const Enter& enter, Corner_table& table)
  {
    put(m_ranks, face(entry, m_mesh), size());
    m_entries.push_back(entry);
    for(int c : {-1, from, -1})
      table.opposite.push_back(c);
    enter(from);
  }

  // Calls `link` with the two other halfedges of triangle `t`, and the corners that they face. `rank` is that of the
  // triangle in its connected part, on which nothing else has an influence.
  //
  // Which comes first, and so on which side the search goes on first, changes irregularly. If it was always the same
  // side, the vertices would have an order with a direction, and coarsening, which follows it, would stretch thin limbs
  // twice as much.
  template <typename Link>
  void link_others(int t, int rank, const Link& link) const
  {
    const halfedge_descriptor second = next(m_entries[t], m_mesh), third = next(second, m_mesh);
    if(static_cast<unsigned>(rank) * 2654435761u >> 31 == 0) {
      link(second, 3 * rank + 2);
      link(third, 3 * rank);
    } else {
      link(third, 3 * rank);
      link(second, 3 * rank + 2);
    }
  }

  // Sets what is across the edge `h` that a corner faces, and enters the face there if it is new. An edge between two
  // faces that were found already is linked from the second one.
  template <typename IsCut, typename Enter>
  void link(halfedge_descriptor h, int corner, int first, const IsCut& is_cut, const Enter& enter,
            Corner_table& table)
  {
    const halfedge_descriptor across = opposite(h, m_mesh);
    if(CGAL::is_border(across, m_mesh))
      return;
    const int t = rank(face(across, m_mesh));
    const bool is_open = is_cut(edge(h, m_mesh));
    if(t < 0 && !is_open) {
      table.opposite[corner] = static_cast<int>(table.opposite.size()) + 1;
      add(across, corner, enter, table);
    } else if(t >= first && t - first <= corner / 3) {
      const int other = 3 * (t - first) + facing_corner(across, t);
      if(is_open)
        table.seam.resize(table.opposite.size(), -1);
      std::vector<int>& side = is_open ? table.seam : table.opposite;
      side[corner] = other;
      side[other] = corner;
    }
  }

  const TriangleMesh& m_mesh;
  Ranks m_ranks;
  std::vector<halfedge_descriptor> m_entries; // of each triangle
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_FACE_SEARCH_H
