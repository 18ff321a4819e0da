// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_SEAMED_COMPONENT_H
#define FLATTEN_MESH_SEAMED_COMPONENT_H

#include "flatten_mesh/plain/Chart.h"
#include "flatten_mesh/plain/Cut_mesh.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace flatten_mesh {

// A component of the input as a mesh of its own, with the seams along which it is cut open.
struct Seamed_component
{
  Cut_mesh part;
  Edge_marks seams;
  Edge_marks forbidden; // edges that must not become seams, because the input does not have them
  std::optional<std::map<Vertex, double>> cones; // of the part, with their angle sums, if they are prescribed
};

// A component without seams yet.
inline Seamed_component make_seamed_component(Mesh& mesh, const Component& component)
{
  Seamed_component result;
  const CGAL::Constant_property_map<Edge, bool> uncut(false);
  result.part = cut_open(mesh, component.faces, component.vertices, uncut);
  Mesh& part = result.part.mesh;
  result.seams = seam_marks(part);
  result.forbidden = diagonals(part);
  const Edge_marks is_diagonal = diagonals(mesh);
  for(const Edge e : part.edges()) {
    result.forbidden[e] = is_diagonal[result.part.edge_origins[e.idx()]];
  }
  return result;
}

inline bool has_seams(const Seamed_component& component)
{
  const auto edges = component.part.mesh.edges();
  return std::any_of(edges.begin(), edges.end(), [&](const Edge e) { return component.seams[e]; });
}

// In units of the square root of the area
inline double length_of_seams(const Seamed_component& component)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  const Mesh& mesh = component.part.mesh;
  double length = 0;
  for(const Edge e : mesh.edges()) {
    length += component.seams[e] ? PMP::edge_length(mesh.halfedge(e), mesh) : 0;
  }
  return length / std::sqrt(PMP::area(mesh));
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_SEAMED_COMPONENT_H
