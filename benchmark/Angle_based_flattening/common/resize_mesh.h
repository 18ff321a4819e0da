// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef BENCHMARKS_COMMON_RESIZE_MESH_H
#define BENCHMARKS_COMMON_RESIZE_MESH_H

#include "read_mesh.h"

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/subdivision_method_3.h>

#include <cstddef>

namespace benchmarks {

// Stops a simplification at a number of faces.
struct Face_count
{
  std::size_t faces;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const
  {
    return profile.surface_mesh().number_of_faces() <= faces;
  }
};

// Makes a mesh of about that many triangles: simplifies it until some number of subdivisions brings it there.
inline Mesh resize_mesh(Mesh mesh, const std::size_t triangles)
{
  int subdivisions = 0;
  std::size_t coarse = triangles;
  for(; coarse > 1.05 * static_cast<double>(mesh.number_of_faces()); coarse /= 4) {
    ++subdivisions;
  }
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, Face_count{coarse});
  mesh.collect_garbage();
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(subdivisions));
  return mesh;
}

} // namespace benchmarks

#endif // BENCHMARKS_COMMON_RESIZE_MESH_H
