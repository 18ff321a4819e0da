// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The data of baking: options, a surface with normals, the simple one with its charts, and the fine one with colors.
// The other headers of `baking/` know both meshes only in this form.

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_SHADED_SURFACES_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_SHADED_SURFACES_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/multiresolution/planar_star.h>
#include <CGAL/Texture_atlas/internal/parameterization_names.h>

#include <Eigen/Core>

#include <vector>

namespace CGAL::Texture_atlas::internal {

typedef Eigen::Vector3d Space_vector;

// Triangles in space with a normal at each vertex
struct Shaded_surface
{
  std::vector<Space_vector> points;
  std::vector<Space_vector> normals; // of each point, of length 1; filled in if empty
  std::vector<int> vertex;           // three for each triangle

  int number_of_triangles() const { return static_cast<int>(vertex.size() / 3); }
};

// The simple surface, with its place in the texture
struct Charted_surface : Shaded_surface
{
  std::vector<Planar_point> uv; // of each corner, in the unit square
  std::vector<long> chart;      // of each triangle, or empty
};

// The fine surface
struct Painted_surface : Shaded_surface
{
  std::vector<Space_vector> colors; // of each point, or empty
};

} // namespace CGAL::Texture_atlas::internal

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_BAKING_SHADED_SURFACES_H
