// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TRIANGULATE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TRIANGULATE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Edge_marks.h>
#include <CGAL/Texture_atlas/internal/prepare/triangulate_polygon.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Divides faces of a mesh. No two edges join the same vertices afterwards unless they did before.
class Face_divider
{
public:
  explicit Face_divider(Mesh& mesh) : m_mesh(mesh)
  {
    m_joined.reserve(2 * mesh.number_of_edges());
    for(const Edge e : mesh.edges()) {
      m_joined.insert(key(mesh.vertex(e, 0), mesh.vertex(e, 1)));
    }
  }

  // Returns false, and leaves the face as it is, if edges between its vertices are in the way.
  bool divide(const Face f)
  {
    std::vector<Halfedge> corners; // of the face: the halfedges that end there
    std::vector<Kernel::Point_3> points;
    for(const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f))) {
      corners.push_back(h);
      points.push_back(m_mesh.point(m_mesh.target(h)));
    }
    const auto is_taken = [&](const Index i, const Index j) {
      return m_joined.count(key(m_mesh.target(corners[i]), m_mesh.target(corners[j]))) > 0;
    };
    const Polygon_triangles triangles = triangulate_polygon(std::move(points), is_taken);
    split(corners, triangles);
    return triangles.size() > 0;
  }

private:
  static std::uint64_t key(const Vertex v, const Vertex w)
  {
    const std::uint64_t least = (std::min)(v.idx(), w.idx()), most = (std::max)(v.idx(), w.idx());
    return least << 32 | most;
  }

  // Cuts off one triangle after the other: those whose corners are close to one another are at the outside.
  void split(std::vector<Halfedge>& corners, const Polygon_triangles& triangles)
  {
    std::vector<std::array<Index, 2>> diagonals;
    for(Index t = 0; t < triangles.size(); ++t) {
      const auto first = triangles.corners.begin() + 3 * t;
      const auto [least, most] = std::minmax_element(first, first + 3);
      diagonals.push_back({*least, *most});
    }
    std::sort(diagonals.begin(), diagonals.end(), [](const auto& a, const auto& b) {
      return a[1] - a[0] < b[1] - b[0] || (a[1] - a[0] == b[1] - b[0] && a[0] < b[0]);
    });
    for(std::size_t i = 0; i + 1 < diagonals.size(); ++i) { // the last one is a side
      const auto [from, to] = diagonals[i];
      m_joined.insert(key(m_mesh.target(corners[from]), m_mesh.target(corners[to])));
      corners[to] = CGAL::Euler::split_face(corners[from], corners[to], m_mesh);
    }
  }

  Mesh& m_mesh;
  std::unordered_set<std::uint64_t> m_joined; // pairs of vertices
};

// Divides all faces of a mesh into triangles, and returns those for which that is not possible.
inline std::vector<Face> triangulate(Mesh& mesh)
{
  std::vector<Face> undivided;
  if(CGAL::is_triangle_mesh(mesh)) {
    return undivided;
  }
  const std::size_t number_of_sides = mesh.number_of_edges();
  const std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  Face_divider divider(mesh);
  for(const Face f : faces) {
    if(!CGAL::is_triangle(mesh.halfedge(f), mesh) && !divider.divide(f)) {
      undivided.push_back(f);
    }
  }
  const Edge_marks is_diagonal = diagonals(mesh);
  for(const Edge e : mesh.edges()) {
    is_diagonal[e] = e.idx() >= number_of_sides; // new edges come last
  }
  return undivided;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TRIANGULATE_H
