// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_AREA_H
#define FLATTEN_MESH_AREA_H

#include "flatten_mesh/plain/Chart.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace flatten_mesh {

// The parts of a component without area, up to the rounding of coordinates.
struct Missing_area
{
  std::size_t triangles = 0;
  bool of_all = false;
  bool is_point = false; // all vertices are at the same place
};

namespace internal {

inline CGAL::Bbox_3 box_of(const Mesh& mesh, const Component& component)
{
  CGAL::Bbox_3 box;
  for(const Vertex v : component.vertices) {
    box += mesh.point(v).bbox();
  }
  return box;
}

} // namespace internal

// If all vertices are on a line, the areas of triangles are rounding errors, at most `rounding` times the squared
// extent.
inline Missing_area missing_area(const Mesh& mesh, const Component& component)
{
  const double rounding = 1e-14;
  const CGAL::Bbox_3 box = internal::box_of(mesh, component);
  const double extent =
      (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  Missing_area missing;
  double sum = 0;
  for(const Face f : component.faces) {
    const Halfedge h = mesh.halfedge(f);
    const Kernel::Point_3 &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                          &r = mesh.point(mesh.target(mesh.next(h)));
    // In units of the extent, squares of numbers near the ends of the range of `double` do not overflow or vanish.
    const Kernel::Vector_3 a = (q - p) / extent, b = (r - p) / extent;
    const double area = std::sqrt(CGAL::cross_product(a, b).squared_length()) / 2;
    missing.triangles += !(area > 0);
    sum += extent > 0 ? area : 0;
  }
  missing.is_point = !(extent > 0);
  missing.of_all = missing.is_point || sum <= rounding;
  return missing;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_AREA_H
