// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_COMPONENTS_H
#define FLATTEN_MESH_COMPONENTS_H

#include "flatten_mesh/model/build_mesh.h"
#include "flatten_mesh/texts.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

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

namespace internal {

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

} // namespace internal

// Whether a component, numbered by falling number of faces, has a border and no handles.
inline bool is_disk_with_holes(Mesh& mesh, const std::size_t component)
{
  return internal::are_disks(mesh, components_by_size(mesh))[component];
}

// Text to append to an error about a component: the option that chooses the largest other component that can be
// flattened, if any.
inline std::string other_component_text(Mesh& mesh, const std::size_t failed)
{
  const std::vector<bool> can = internal::are_disks(mesh, components_by_size(mesh));
  for(std::size_t c = 0; c < can.size(); ++c) {
    if(can[c] && c != failed) {
      return "; another of the " + std::to_string(can.size()) +
             " components can be flattened, with --component " + std::to_string(c);
    }
  }
  return "";
}

// A connected component of a mesh.
struct Component
{
  std::vector<Face> faces;
  std::vector<Vertex> vertices; // by rising number
  std::size_t number;           // by falling number of faces, from 0
  std::size_t components;       // of the whole mesh
};

namespace internal {

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

// "there is 1 border, number 0", "there are 3 borders, numbers 0 to 2".
inline std::string choice_text(const std::size_t count, const std::string& noun)
{
  return count == 1 ? "there is 1 " + noun + ", number 0"
                    : "there are " + std::to_string(count) + " " + noun + "s, numbers 0 to " +
                          std::to_string(count - 1);
}

} // namespace internal

// The component that `--component` chooses. Throws an `Input_error` if there is none.
inline Component choose_component(Mesh& mesh, const std::size_t component)
{
  std::vector<std::vector<Face>> components = components_by_size(mesh);
  if(component >= components.size()) {
    throw Input_error("no component " + std::to_string(component) + ": " +
                      internal::choice_text(components.size(), "component") + "; choose with --component");
  }
  const std::vector<Vertex> vertices = internal::vertices_of_faces(mesh, components[component]);
  return {std::move(components[component]), vertices, component, components.size()};
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_COMPONENTS_H
