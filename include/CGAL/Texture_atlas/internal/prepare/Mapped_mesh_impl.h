// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MAPPED_MESH_IMPL_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MAPPED_MESH_IMPL_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/atlas/mesh_atlas_builder.h>
#include <CGAL/Texture_atlas/internal/prepare/Mapped_mesh.h>

#include <CGAL/boost/graph/named_params_helper.h>

#include <deque>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// Here, so that they are compiled once
CGAL_ANGLE_BASED_FLATTENING_INLINE Mapped_mesh::Mapped_mesh() = default;
CGAL_ANGLE_BASED_FLATTENING_INLINE Mapped_mesh::~Mapped_mesh() = default;

CGAL_ANGLE_BASED_FLATTENING_INLINE void Mapped_mesh::add_maps()
{
  seams = mesh.add_property_map<Edge, bool>("e:seam", false).first;
  uv = mesh.add_property_map<Halfedge, Kernel::Point_2>("h:uv").first;
  charts = mesh.add_property_map<Face, int>("f:chart", -1).first;
  is_constrained = mesh.add_property_map<Edge, bool>("e:constrained", false).first;
  weights = mesh.add_property_map<Edge, double>("e:weight", 0).first;
  sizes = mesh.add_property_map<Face, double>("f:size", 1).first;
  polygons = mesh.add_property_map<Face, std::size_t>("f:polygon", 0).first;
  face_numbers = mesh.add_property_map<Face, std::ptrdiff_t>("f:number", 0).first;
  vertex_numbers = mesh.add_property_map<Vertex, std::ptrdiff_t>("v:number", 0).first;
}

CGAL_ANGLE_BASED_FLATTENING_INLINE Report_on_atlas
make_atlas_of_mapped_meshes(const std::vector<Mapped_mesh*>& meshes, const Atlas_options& options,
                            const Linear_solvers& solvers, const Rounding round)
{
  const auto parameters_of = [](const Mapped_mesh& mesh) {
    return parameters::edge_weight_map(mesh.weights)
        .edge_is_constrained_map(mesh.is_constrained)
        .face_size_map(mesh.sizes)
        .face_patch_map(mesh.polygons)
        .face_index_map(mesh.face_numbers)
        .vertex_index_map(mesh.vertex_numbers);
  };
  typedef decltype(parameters_of(*meshes.front())) Parameters;
  std::deque<Parameters> np;
  Mesh_atlas_builder<Mesh, decltype(Mapped_mesh::seams), decltype(Mapped_mesh::uv),
                     decltype(Mapped_mesh::charts), Parameters>
      builder(options, solvers, round);
  for(Mapped_mesh* const mesh : meshes) {
    np.push_back(parameters_of(*mesh));
    builder.add(mesh->mesh, mesh->seams, mesh->uv, mesh->charts, np.back());
  }
  return builder.run();
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_MAPPED_MESH_IMPL_H
