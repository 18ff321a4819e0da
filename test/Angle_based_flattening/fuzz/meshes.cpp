// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <vector>

namespace fuzz {

namespace {

namespace Euler = CGAL::Euler;
namespace PMP = CGAL::Polygon_mesh_processing;

typedef Mesh::Halfedge_index Halfedge;
typedef std::array<std::size_t, 3> Triangle;

const int largest = 60; // number of triangles or operations, for fast runs

// At an edge of an earlier triangle, or between any three points.
Triangle next_triangle(Bytes& bytes, const std::vector<Triangle>& triangles, int points)
{
  const int kind = bytes.byte();
  const std::size_t third = static_cast<std::size_t>(bytes.below(points));
  if(kind < 16 || triangles.empty())
    return {static_cast<std::size_t>(bytes.below(points)), static_cast<std::size_t>(bytes.below(points)),
            third};
  const Triangle& neighbour = triangles[static_cast<std::size_t>(bytes.byte()) % triangles.size()];
  return {neighbour[(kind + 1) % 3], neighbour[kind % 3], third};
}

// Each results in a valid triangle mesh without loops, which need not be a simplicial complex.
class Operations
{
public:
  Operations(Bytes& bytes, Mesh& mesh, bool extreme) : m_bytes(bytes), m_mesh(mesh), m_extreme(extreme) {}

  void apply(int operation, Halfedge h)
  {
    switch(operation) {
    case 0:
      return split_face(h);
    case 1:
      return split_edge(h);
    case 2:
      return collapse(h);
    case 3:
      return flip(h);
    case 4:
      return close_corner(h);
    case 5:
      return remove_face(h);
    case 6:
      return fill_hole(h);
    default:
      return add_triangle(h);
    }
  }

  Point_3 point() { return m_bytes.point({m_mesh.points().begin(), m_mesh.points().end()}, m_extreme); }

private:
  bool is_border(Halfedge h) const { return m_mesh.is_border(h); }

  void split_face(Halfedge h)
  {
    if(!is_border(h))
      m_mesh.point(target(Euler::add_center_vertex(h, m_mesh), m_mesh)) = point();
  }

  void split_edge(Halfedge h)
  {
    const Halfedge across = opposite(h, m_mesh);
    const Halfedge first = Euler::split_edge(h, m_mesh);
    m_mesh.point(target(first, m_mesh)) = point();
    if(!is_border(first))
      Euler::split_face(first, next(next(first, m_mesh), m_mesh), m_mesh);
    if(!is_border(across))
      Euler::split_face(across, next(next(across, m_mesh), m_mesh), m_mesh);
  }

  bool are_joined(Halfedge to_v, Halfedge to_w) const
  {
    return halfedge(target(to_v, m_mesh), target(to_w, m_mesh), m_mesh).second;
  }

  // CGAL's test is valid for simplicial complexes only.
  void collapse(Halfedge h)
  {
    if(m_is_complex && Euler::does_satisfy_link_condition(edge(h, m_mesh), m_mesh))
      Euler::collapse_edge(edge(h, m_mesh), m_mesh);
  }

  void flip(Halfedge h)
  {
    const Halfedge across = opposite(h, m_mesh);
    if(!is_border(h) && !is_border(across) && m_mesh.degree(target(h, m_mesh)) > 2 &&
       m_mesh.degree(source(h, m_mesh)) > 2 &&
       target(next(h, m_mesh), m_mesh) != target(next(across, m_mesh), m_mesh)) {
      m_is_complex = m_is_complex && !are_joined(next(h, m_mesh), next(across, m_mesh));
      Euler::flip_edge(h, m_mesh);
    }
  }

  void add_triangle(Halfedge h)
  {
    if(is_border(h))
      m_mesh.point(target(Euler::add_vertex_and_face_to_border(prev(h, m_mesh), h, m_mesh), m_mesh)) =
          point();
  }

  // Fills a corner of a border with a triangle. The border may have only two edges afterwards.
  void close_corner(Halfedge h)
  {
    const Halfedge second = next(next(h, m_mesh), m_mesh);
    if(!is_border(h) || target(second, m_mesh) == target(h, m_mesh) || next(second, m_mesh) == h)
      return;
    m_is_complex = m_is_complex && !are_joined(h, second);
    Euler::add_face_to_border(h, second, m_mesh);
  }

  // Only in the interior, so that the surface is not pinched.
  void remove_face(Halfedge h)
  {
    if(is_border(h))
      return;
    for(const Halfedge g : halfedges_around_face(h, m_mesh))
      if(CGAL::is_border(target(g, m_mesh), m_mesh))
        return;
    Euler::remove_face(h, m_mesh);
  }

  void fill_hole(Halfedge h)
  {
    if(!is_border(h))
      return;
    m_is_complex = m_is_complex && next(next(h, m_mesh), m_mesh) != h;
    Euler::fill_hole(h, m_mesh);
    split_face(h);
  }

  Bytes& m_bytes;
  Mesh& m_mesh;
  const bool m_extreme;
  bool m_is_complex = true; // without parallel edges
};

} // namespace

Mesh mesh_of_soup(Bytes& bytes)
{
  const bool extreme = bytes.below(4) == 0;
  std::vector<Point_3> points;
  for(int n = 3 + bytes.below(22); n > 0; --n)
    points.push_back(bytes.point(points, extreme));
  std::vector<Triangle> triangles;
  const int number_of_points = static_cast<int>(points.size());
  for(int n = 0; n < largest && !bytes.is_empty(); ++n) {
    const Triangle t = next_triangle(bytes, triangles, number_of_points);
    if(t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      triangles.push_back(t);
  }
  Mesh mesh;
  PMP::orient_polygon_soup(points, triangles);
  if(PMP::is_polygon_soup_a_polygon_mesh(triangles))
    PMP::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  return mesh;
}

Mesh mesh_of_operations(Bytes& bytes)
{
  Mesh mesh;
  CGAL::make_triangle(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), mesh);
  Operations operations(bytes, mesh, bytes.below(4) == 0);
  for(int n = 0; n < largest && !bytes.is_empty(); ++n) {
    const int operation = bytes.below(12);
    const Halfedge h(static_cast<Mesh::size_type>(bytes.byte()) % (2 * mesh.num_edges()));
    if(!mesh.is_removed(h))
      operations.apply(operation, h);
  }
  mesh.collect_garbage();
  return mesh;
}

} // namespace fuzz
