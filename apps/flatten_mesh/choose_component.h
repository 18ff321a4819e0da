// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHOOSE_COMPONENT_H
#define FLATTEN_MESH_CHOOSE_COMPONENT_H

#include "flatten_mesh/texts.h"

#include <CGAL/Texture_atlas/internal/prepare/components.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// Text to append to an error about a component: the option that chooses the largest other component that can be
// flattened, if any.
inline std::string other_component_text(Mesh& mesh, const std::size_t failed)
{
  const std::vector<bool> can = are_disks(mesh, components_by_size(mesh));
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
  const std::vector<Vertex> vertices = vertices_of_faces(mesh, components[component]);
  return {std::move(components[component]), vertices, component, components.size()};
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHOOSE_COMPONENT_H
