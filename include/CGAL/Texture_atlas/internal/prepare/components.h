// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_COMPONENTS_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_COMPONENTS_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/build_mesh.h>

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Texture_atlas::internal::prepare {

// The faces of each component, the largest component first.
inline std::vector<std::vector<Face>> components_by_size(Mesh& mesh)
{
  auto component = mesh.add_property_map<Face, Index>("f:flatten_mesh_component", 0).first;
  std::vector<std::vector<Face>> components(
      CGAL::Polygon_mesh_processing::connected_components(mesh, component));
  for(const Face f : mesh.faces()) {
    components[component[f]].push_back(f);
  }
  mesh.remove_property_map(component);
  for(std::vector<Face>& faces : components) {
    faces.shrink_to_fit();
  }
  std::stable_sort(components.begin(), components.end(),
                   [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return components;
}

// Whether each component is a disk, perhaps with holes: by Euler's formula, whether it has a border and no handle.
inline std::vector<bool> are_disks(const Mesh& mesh, const std::vector<std::vector<Face>>& components)
{
  std::vector<std::size_t> component(mesh.number_of_faces());
  for(std::size_t c = 0; c < components.size(); ++c) {
    for(const Face f : components[c]) {
      component[f.idx()] = c;
    }
  }
  const auto component_of = [&](const Halfedge h) {
    return component[mesh.face(mesh.is_border(h) ? mesh.opposite(h) : h).idx()];
  };
  std::vector<long long> characteristic(components.size(), 0), borders(components.size(), 0);
  for(const Vertex v : mesh.vertices()) {
    if(!mesh.is_isolated(v)) {
      ++characteristic[component_of(mesh.halfedge(v))];
    }
  }
  for(const Mesh::Edge_index e : mesh.edges()) {
    --characteristic[component_of(mesh.halfedge(e))];
  }
  std::vector<Halfedge> cycles;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  for(const Halfedge h : cycles) {
    ++borders[component_of(h)];
  }
  std::vector<bool> result;
  for(std::size_t c = 0; c < components.size(); ++c) {
    const long long faces = static_cast<long long>(components[c].size());
    result.push_back(borders[c] > 0 && characteristic[c] + faces + borders[c] == 2);
  }
  return result;
}

// Whether a component, numbered by falling number of faces, has a border and no handles.
inline bool is_disk_with_holes(Mesh& mesh, const std::size_t component)
{
  return are_disks(mesh, components_by_size(mesh))[component];
}

// By rising number
inline std::vector<Vertex> vertices_of_faces(const Mesh& mesh, const std::vector<Face>& faces)
{
  std::vector<bool> is_used(mesh.number_of_vertices(), false);
  for(const Face f : faces) {
    for(const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      is_used[v.idx()] = true;
    }
  }
  std::vector<Vertex> vertices;
  std::copy_if(mesh.vertices_begin(), mesh.vertices_end(), std::back_inserter(vertices),
               [&is_used](const Vertex v) { return is_used[v.idx()]; });
  return vertices;
}

} // namespace CGAL::Texture_atlas::internal::prepare

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_COMPONENTS_H
