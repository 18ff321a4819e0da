// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_EDGE_MARKS_H
#define FLATTEN_MESH_EDGE_MARKS_H

#include "flatten_mesh/model/Corner_origins.h"

namespace flatten_mesh {

using Edge_marks = Mesh::Property_map<Edge, bool>;

// The edges along which a mesh is cut open.
inline Edge_marks seam_marks(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>("e:flatten_mesh_seam", false).first;
}

// The edges that divide larger polygons into triangles.
inline Edge_marks diagonals(Mesh& mesh)
{
  return mesh.add_property_map<Edge, bool>("e:flatten_mesh_diagonal", false).first;
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_EDGE_MARKS_H
