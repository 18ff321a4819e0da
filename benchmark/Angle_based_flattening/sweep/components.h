// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SWEEP_COMPONENTS_H
#define SWEEP_COMPONENTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <string>
#include <vector>

namespace sweep {

typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Mesh;

struct Component
{
  long triangles = 0;
  std::vector<Mesh::Halfedge_index> borders; // one halfedge of each
};

// Polygons are triangulated, and what is not a manifold is taken apart. Returns `false` if there is no surface.
bool read_surface(const std::string& file, Mesh& mesh);

std::vector<Component> find_components(Mesh& mesh);

} // namespace sweep

#endif // SWEEP_COMPONENTS_H
