// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MAPPED_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MAPPED_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/chart/flattening.h>
#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/linear_algebra/linear_solvers.h>
#include <CGAL/Texture_atlas/Atlas_options.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// A mesh with the property maps that `make_atlas()` takes
struct Mapped_mesh
{
  Surface_of_model surface;
  Mesh& mesh = surface.mesh;

  Mesh::Property_map<Edge, bool> seams, is_constrained;
  Mesh::Property_map<Edge, double> weights;
  Mesh::Property_map<Halfedge, Kernel::Point_2> uv;
  Mesh::Property_map<Face, int> charts;
  Mesh::Property_map<Face, double> sizes;
  Mesh::Property_map<Face, std::size_t> polygons;
  Mesh::Property_map<Face, std::ptrdiff_t> face_numbers;     // in messages
  Mesh::Property_map<Vertex, std::ptrdiff_t> vertex_numbers; // the same

  CGAL_ANGLE_BASED_FLATTENING_INLINE Mapped_mesh();
  CGAL_ANGLE_BASED_FLATTENING_INLINE ~Mapped_mesh();
  Mapped_mesh(const Mapped_mesh&) = delete;
  Mapped_mesh& operator=(const Mapped_mesh&) = delete;

  CGAL_ANGLE_BASED_FLATTENING_INLINE void add_maps();
};

// Makes one atlas of meshes, in their maps. `round` rounds coordinates to the caller's number type.
CGAL_ANGLE_BASED_FLATTENING_INLINE Report_on_atlas
make_atlas_of_mapped_meshes(const std::vector<Mapped_mesh*>& meshes, const Atlas_options& options,
                            const Linear_solvers& solvers, Rounding round);

} // namespace CGAL::Texture_atlas::internal::prepare

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/prepare/Mapped_mesh_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MAPPED_MESH_H
