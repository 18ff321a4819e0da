// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TRIANGULATE_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_TRIANGULATE_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Ear_cutter.h>
#include <CGAL/Texture_atlas/internal/prepare/Flat_polygon.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Replaces diagonals by those of Delaunay triangles on the surface, where they are inside of the polygon and not taken.
template <class Is_taken>
class Diagonal_flipper
{
public:
  Diagonal_flipper(const Flat_polygon& polygon, const Is_taken& is_taken, Polygon_triangles& triangles)
      : m_polygon(polygon), m_is_taken(is_taken), m_corners(triangles.corners),
        m_opposites(triangles.opposites)
  {}

  void run()
  {
    std::vector<Index> stack;
    for(Index c = 0; c < m_corners.size(); ++c) {
      if(m_opposites[c] != no_index && c < m_opposites[c]) {
        stack.push_back(c);
      }
    }
    std::size_t left = 4 * m_corners.size(); // what is not planar need not come to an end
    while(!stack.empty() && left > 0) {
      const Index c = stack.back();
      stack.pop_back();
      if(m_opposites[c] != no_index && is_to_flip(c)) {
        --left;
        flip(c);
        const Index across = m_opposites[next(c)];
        stack.insert(stack.end(), {c, next(next(c)), next(across), next(next(across))});
      }
    }
  }

private:
  static Index next(const Index c) { return c % 3 == 2 ? c - 2 : c + 1; }

  bool turns_left(const Index i, const Index j, const Index k) const
  {
    return m_polygon.turn(i, j, k) == CGAL::LEFT_TURN;
  }

  bool is_to_flip(const Index c) const
  {
    const Index o = m_opposites[c], i = m_corners[c], j = m_corners[next(c)], k = m_corners[o],
                l = m_corners[next(o)];
    if(m_is_taken(i, k) || !turns_left(i, j, k) || !turns_left(k, l, i)) {
      return false;
    }
    return !turns_left(i, j, l) || !turns_left(k, l, j) ||
           m_polygon.cotangent(i, j, l) + m_polygon.cotangent(k, l, j) < -1e-9;
  }

  // The triangles i, j, l and k, l, j become i, j, k and k, l, i.
  void flip(const Index c)
  {
    const Index o = m_opposites[c], c1 = next(c), c2 = next(c1), o1 = next(o), o2 = next(o1);
    const Index side_of_c = m_opposites[c1], side_of_o = m_opposites[o1];
    m_corners[c2] = m_corners[o];
    m_corners[o2] = m_corners[c];
    join(c, side_of_o);
    join(o, side_of_c);
    join(c1, o1);
  }

  void join(const Index c, const Index o)
  {
    m_opposites[c] = o;
    if(o != no_index) {
      m_opposites[o] = c;
    }
  }

  const Flat_polygon& m_polygon;
  const Is_taken& m_is_taken;
  std::vector<Index>& m_corners;
  std::vector<Index>& m_opposites;
};

// The diagonal of a quadrangle for which both triangles are large and face the same way, as CGAL chooses it
template <class Is_taken>
Polygon_triangles divide_quadrangle(const Flat_polygon& polygon, const Is_taken& is_taken)
{
  const bool is_first =
      polygon.area(0, 1, 2) * polygon.area(2, 3, 0) > polygon.area(1, 2, 3) * polygon.area(3, 0, 1);
  for(const bool is_from_first : {is_first, !is_first}) {
    if(is_from_first && !is_taken(Index(0), Index(2))) {
      return {{0, 1, 2, 2, 3, 0}, {no_index, 4, no_index, no_index, 1, no_index}};
    }
    if(!is_from_first && !is_taken(Index(1), Index(3))) {
      return {{1, 2, 3, 3, 0, 1}, {no_index, 4, no_index, no_index, 1, no_index}};
    }
  }
  return {};
}

// Divides a polygon into triangles between its corners: any polygon, also one that is not planar, crosses itself, or
// has corners at the same place. With n corners there are n - 2. In planar polygons that do not cross themselves all
// are inside, and as those of Delaunay. Diagonals for which `is_taken(i, j)` is true are not used; if no way without is
// found, the result is empty.
template <class Is_taken>
Polygon_triangles triangulate_polygon(std::vector<Kernel::Point_3> points, const Is_taken& is_taken)
{
  const Flat_polygon polygon(std::move(points));
  if(polygon.size() == 4) {
    return divide_quadrangle(polygon, is_taken);
  }
  Polygon_triangles triangles = Ear_cutter<Is_taken>(polygon, is_taken).run();
  Diagonal_flipper<Is_taken>(polygon, is_taken, triangles).run();
  return triangles;
}

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

  // Returns false, and leaves the face as it is, if edges between its vertices are in the way, or points are no points.
  bool divide(const Face f)
  {
    std::vector<Halfedge> corners; // of the face: the halfedges that end there
    std::vector<Kernel::Point_3> points;
    for(const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(f))) {
      corners.push_back(h);
      points.push_back(m_mesh.point(m_mesh.target(h)));
      if(!is_finite(points.back())) {
        return false;
      }
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
