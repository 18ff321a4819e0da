// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ATLAS_H
#define FLATTEN_MESH_ATLAS_H

#include "flatten_mesh/model/build_mesh.h"

namespace flatten_mesh {

// The charts of a mesh, as properties of it
struct Atlas
{
  Mesh::Property_map<Halfedge, Kernel::Point_2> uv; // at the target of a halfedge in its face
  Mesh::Property_map<Face, int> chart;              // from 0 on; -1 without one
  Edge_marks seams;
};

inline Atlas empty_atlas(Mesh& mesh)
{
  return {mesh.add_property_map<Halfedge, Kernel::Point_2>("h:flatten_mesh_uv").first,
          mesh.add_property_map<Face, int>("f:flatten_mesh_chart", -1).first, seam_marks(mesh)};
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_ATLAS_H
