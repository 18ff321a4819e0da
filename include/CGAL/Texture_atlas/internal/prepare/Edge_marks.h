// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_EDGE_MARKS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_EDGE_MARKS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

namespace CGAL::Texture_atlas::internal::prepare {

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

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_EDGE_MARKS_H
