// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SCALE_STRETCH_H
#define FLATTEN_MESH_SCALE_STRETCH_H

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/Run_record.h"

#include <CGAL/number_utils.h>

#include <cmath>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Areas in space and in the plane.
struct Area_pair
{
  double space = 0;
  double plane = 0;
};

inline Area_pair areas_of_face(const Mesh& mesh, const UV_map& uv, const Face f)
{
  const Halfedge h = mesh.halfedge(f);
  const Vertex a = mesh.source(h), b = mesh.target(h), c = mesh.target(mesh.next(h));
  const double squared = CGAL::squared_area(mesh.point(a), mesh.point(b), mesh.point(c));
  return {std::sqrt(squared), CGAL::area(uv[a], uv[b], uv[c])};
}

} // namespace internal

// How much areas vary in the plane, as a stretch of lengths; 1 is perfect. In contrast to the L2 stretch it does not
// depend on the shapes of triangles.
inline double scale_stretch(const Mesh& mesh, const Chart& chart, const UV_map& uv)
{
  double space = 0, plane = 0, sum = 0;
  for(const Face f : chart.faces) {
    const internal::Area_pair area = internal::areas_of_face(mesh, uv, f);
    space += area.space;
    plane += area.plane;
    sum += area.space > 0 ? area.space * area.space / area.plane : 0;
  }
  return std::sqrt(sum * plane) / space;
}

// The triangles around a vertex
struct Vertex_scale
{
  double area = 0;      // in space
  double log_scale = 0; // logarithm of the factor of lengths, relative to the mean
};

// Of each vertex of the mesh before it was cut; 0 for vertices off the chart. `number_of_vertices` is that of this
// mesh.
inline std::vector<Vertex_scale> vertex_scales(const Mesh& mesh, const Chart& chart, const UV_map& uv,
                                               const std::vector<Vertex>& origins,
                                               const std::size_t number_of_vertices)
{
  std::vector<internal::Area_pair> areas(number_of_vertices);
  double mean = 0, total = 0;
  for(const Face f : chart.faces) {
    const internal::Area_pair area = internal::areas_of_face(mesh, uv, f);
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      areas[origins[v.idx()].idx()].space += area.space;
      areas[origins[v.idx()].idx()].plane += area.plane;
    }
  }
  const auto log_scale = [](const internal::Area_pair& area) {
    return area.space > 0 && area.plane > 0 ? std::log(area.plane / area.space) / 2 : 0.;
  };
  for(const internal::Area_pair& area : areas) {
    mean += area.space * log_scale(area);
    total += area.space;
  }
  std::vector<Vertex_scale> result;
  for(const internal::Area_pair& area : areas) {
    result.push_back({area.space, area.space > 0 ? log_scale(area) - mean / total : 0.});
  }
  return result;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SCALE_STRETCH_H
