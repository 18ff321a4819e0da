// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_MEND_POLYGONS_H
#define FLATTEN_MESH_MEND_POLYGONS_H

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/Run_record.h"

#include <CGAL/Texture_atlas/internal/polygons/make_polygons_convex.h>

#include <cstddef>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The triangles of a chart. Its vertices have the numbers that they have in the mesh.
template <class Is_diagonal>
TA::internal::Divided_polygons divided_polygons(const Mesh& mesh, const Chart& chart,
                                                const Is_diagonal& is_diagonal)
{
  TA::internal::Divided_polygons table;
  std::vector<int> corner(mesh.number_of_halfedges(), -1); // that faces each halfedge
  for(const Face f : chart.faces) {
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      corner[h.idx()] = table.number_of_corners();
      table.vertex.push_back(static_cast<int>(mesh.target(mesh.next(h)).idx()));
    }
  }
  table.is_fixed.assign(mesh.number_of_vertices(), false);
  for(const Face f : chart.faces) {
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const Halfedge across = mesh.opposite(h);
      table.opposite.push_back(corner[across.idx()]);
      table.is_diagonal.push_back(is_diagonal(mesh.edge(h)));
      if(mesh.is_border(across)) {
        table.is_fixed[mesh.source(h).idx()] = table.is_fixed[mesh.target(h).idx()] = true;
      }
    }
  }
  return table;
}

} // namespace internal

// Moves vertices a little, to places on the grid, so that polygons become convex in the plane, and returns of how many
// that is true. The measures have to be taken again.
template <class Is_diagonal>
std::size_t mend_polygons(const Mesh& mesh, const Chart& chart, const Is_diagonal& is_diagonal,
                          const CGAL::Surface_mesh_parameterization::internal::ABF::Float_grid& grid,
                          const UV_map& uv)
{
  std::vector<CGAL::Surface_mesh_parameterization::internal::ABF::Chart::Point_2> points(
      mesh.number_of_vertices());
  for(const Vertex v : chart.vertices) {
    points[v.idx()] = {uv[v].x(), uv[v].y()};
  }
  const CGAL::Texture_atlas::internal::Divided_polygons table =
      internal::divided_polygons(mesh, chart, is_diagonal);
  const std::size_t count = CGAL::Texture_atlas::internal::Polygon_mender(table, grid, points).run();
  for(const Vertex v : chart.vertices) {
    uv[v] = Kernel::Point_2(points[v.idx()].x(), points[v.idx()].y());
  }
  return count;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_MEND_POLYGONS_H
