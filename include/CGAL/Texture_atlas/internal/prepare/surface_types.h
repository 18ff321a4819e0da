// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_TYPES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_TYPES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/Surface_soup.h>

#include <CGAL/Surface_mesh.h>

namespace CGAL::Texture_atlas::internal::prepare {

using Texture_atlas::Surface_soup;
using Kernel = Surface_soup::Kernel;
using Index = Surface_soup::Index;
constexpr Index no_index = Surface_soup::none;

using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;

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

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_SURFACE_TYPES_H
