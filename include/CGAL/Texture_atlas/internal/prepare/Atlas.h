// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_ATLAS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_ATLAS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/Diagnosis.h>
#include <CGAL/Texture_atlas/Atlas_report.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/surface_types.h>

namespace CGAL::Texture_atlas::internal::prepare {

using Report_on_atlas = Surface_mesh_parameterization::Mesh_report<Mesh, Atlas_report>;

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

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_ATLAS_H
