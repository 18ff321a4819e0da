// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_BUILD_MESH_H
#define CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_BUILD_MESH_H

#include <CGAL/license/Surface_mesh_parameterization.h>

#include <CGAL/Texture_atlas/internal/prepare/Input_error.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>
#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

namespace CGAL::Texture_atlas::internal::prepare {

// A triangulated surface, and where it is in the file.
struct Surface_of_model
{
  Mesh mesh;
  Corner_origins origins;
};

// The triangulated surface of the polygons of a model, which are repaired if necessary and requested. Its vertices are
// those of the repaired soup, in the same order; larger polygons are divided into triangles. Throws an `Input_error`
// that names the place unless the polygons form an oriented manifold with finite coordinates.
Surface_of_model build_mesh(const Surface_soup& model, Polygon_soup& soup, bool repair, Notes& notes,
                            const Welding& welding = Welding());

// Divides the larger polygons of a mesh into triangles, except where that is not possible. Sets the corners of
// `origins` to the numbers of halfedges before.
void divide_polygons(Surface_of_model& surface);

} // namespace CGAL::Texture_atlas::internal::prepare

#ifndef CGAL_ANGLE_BASED_FLATTENING_COMPILED
#include <CGAL/Texture_atlas/internal/prepare/build_mesh_impl.h>
#endif

#endif // CGAL_TEXTURE_ATLAS_INTERNAL_PREPARE_BUILD_MESH_H
