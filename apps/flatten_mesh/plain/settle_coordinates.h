// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SETTLE_COORDINATES_H
#define FLATTEN_MESH_SETTLE_COORDINATES_H

#include "flatten_mesh/output_floats.h"
#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/plain/Sheet.h"
#include "flatten_mesh/plain/flatten_sheet.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/local_injectivity.h>
#include <CGAL/Texture_atlas/internal/polygons/make_polygons_convex.h>
#include <CGAL/Texture_atlas/internal/polygons/round_to_floats.h>

#include <cstddef>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

namespace ABF = CGAL::Texture_atlas::internal;

using Planar_points = std::vector<ABF::Chart::Point_2>; // by the number of the vertex in the mesh

inline Planar_points planar_points(const Sheet& sheet, const UV_map& uv)
{
  Planar_points points(sheet.mesh().number_of_vertices());
  for(const Vertex v : sheet.vertices) {
    points[v.idx()] = {uv[v].x(), uv[v].y()};
  }
  return points;
}

inline void move_to(const Planar_points& points, const Sheet& sheet, Flattening& flattening)
{
  for(const Vertex v : sheet.vertices) {
    flattening.uv[v] = Kernel::Point_2(points[v.idx()].x(), points[v.idx()].y());
  }
  measure(sheet, flattening);
}

// The triangles of a sheet. Its vertices have the numbers that they have in the mesh.
inline internal::ABF::Divided_polygons divided_polygons(const Sheet& sheet)
{
  const Mesh& mesh = sheet.mesh();
  const Edge_marks is_diagonal = diagonals(*sheet.input);
  internal::ABF::Divided_polygons table;
  std::vector<int> corner(mesh.number_of_halfedges(), -1); // that faces each halfedge
  for(const Face f : sheet.faces) {
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      corner[h.idx()] = table.number_of_corners();
      table.vertex.push_back(static_cast<int>(mesh.target(mesh.next(h)).idx()));
    }
  }
  table.is_fixed.assign(mesh.number_of_vertices(), false);
  for(const Face f : sheet.faces) {
    for(const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      table.opposite.push_back(corner[mesh.opposite(h).idx()]);
      table.is_diagonal.push_back(is_diagonal[sheet.input_edge(mesh.edge(h))]);
      if(mesh.is_border(mesh.opposite(h))) {
        table.is_fixed[mesh.source(h).idx()] = table.is_fixed[mesh.target(h).idx()] = true;
      }
    }
  }
  return table;
}

} // namespace internal

// Rounds the coordinates to those that the output holds, and measures them. The flattening fails if they are no map
// then.
inline void round_coordinates(const Command_line& command, const Sheet& sheet, Flattening& flattening)
{
  const internal::ABF::Divided_polygons table = internal::divided_polygons(sheet);
  internal::Planar_points points = internal::planar_points(sheet, flattening.uv);
  std::vector<int> targets; // of the edge that each corner faces
  std::vector<internal::ABF::Border_edge> border;
  for(int c = 0; c < table.number_of_corners(); ++c) {
    const int next = c % 3 == 2 ? c - 2 : c + 1, last = c % 3 == 0 ? c + 2 : c - 1;
    targets.push_back(table.vertex[last]);
    if(table.opposite[c] < 0) {
      border.push_back({table.vertex[next], table.vertex[last]});
    }
  }
  internal::ABF::Float_rounder rounder(targets, grid_of_outputs(command), points);
  rounder.keep_gaps(border);
  const std::vector<int> bad = rounder.run();
  const bool was_simple = flattening.measures.border_is_simple;
  internal::move_to(points, sheet, flattening);
  if(bad.empty() && (flattening.measures.border_is_simple || !was_simple)) {
    return;
  }
  flattening.report.status = SMP::Diagnosis::PRECISION_EXCEEDED;
  flattening.report.message = "the output holds coordinates in float, which has too few digits for " +
                              (bad.empty() ? std::string("the border") : count_text(bad.size(), "triangle")) +
                              "; use an OBJ file";
}

// Makes polygons convex in the plane where small moves of vertices, to places that the output holds, do that. Returns
// how many.
inline std::size_t mend_polygons(const Command_line& command, const Sheet& sheet, Flattening& flattening)
{
  const internal::ABF::Divided_polygons table = internal::divided_polygons(sheet);
  internal::Planar_points points = internal::planar_points(sheet, flattening.uv);
  const std::size_t count = internal::ABF::Polygon_mender(table, grid_of_outputs(command), points).run();
  if(count > 0) {
    internal::move_to(points, sheet, flattening);
  }
  return count;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SETTLE_COORDINATES_H
