// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Numbers the faces of a mesh in the order of a breadth-first search, so that neighbours are close in memory.
// `read_chart.h` and `read_surface.h` make their corner tables from it.

#ifndef CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_ENTERED_FACES_H
#define CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_ENTERED_FACES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <vector>

namespace CGAL::Surface_mesh_parameterization::internal::ABF {

// The faces that a breadth-first search over a mesh has found, in its order, so that neighbours are near to each other
// in memory. They are the triangles of a corner table: the corners are at the targets of the halfedge by which the
// search entered the face, of the next one, and of the one after that. The second one faces the entry.
template <typename TriangleMesh>
class Entered_faces
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename boost::property_map<TriangleMesh, CGAL::dynamic_face_property_t<int>>::const_type Ranks;

public:
  explicit Entered_faces(const TriangleMesh& mesh) : m_mesh(mesh) {}

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

  // Adds face `f`, by its halfedge `entry`.
  void enter(halfedge_descriptor entry, face_descriptor f)
  {
    put(m_ranks, f, size());
    m_entries.push_back(entry);
  }

  bool is_triangle(int t) const
  {
    const halfedge_descriptor second = next(m_entries[t], m_mesh);
    return second != m_entries[t] && next(next(second, m_mesh), m_mesh) == m_entries[t];
  }

  // Calls `link` with the two other halfedges of triangle `t`, and the corners that they face: 2 or 0 of the triangle.
  // `rank` is that of the triangle in its connected part, on which nothing else has an influence.
  //
  // Which comes first, and so on which side the search goes on first, changes irregularly. If it was always the same
  // side, the vertices would have an order with a direction, and coarsening, which follows it, would stretch thin limbs
  // twice as much.
  template <typename Link>
  void link_others(int t, int rank, const Link& link) const
  {
    const halfedge_descriptor second = next(m_entries[t], m_mesh), third = next(second, m_mesh);
    if(static_cast<unsigned>(rank) * 2654435761u >> 31 == 0) {
      link(second, 2);
      link(third, 0);
    } else {
      link(third, 0);
      link(second, 2);
    }
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
  const TriangleMesh& m_mesh;
  Ranks m_ranks;
  std::vector<halfedge_descriptor> m_entries; // of each triangle
};

} // namespace CGAL::Surface_mesh_parameterization::internal::ABF

#endif // CGAL_SMP_INTERNAL_ANGLE_BASED_FLATTENING_CHART_ENTERED_FACES_H
