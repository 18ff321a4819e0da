// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BUILD_MESH_H
#define FLATTEN_MESH_BUILD_MESH_H

#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Corner_origins.h"
#include "flatten_mesh/model/Edge_marks.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Polygon_soup.h"
#include "flatten_mesh/model/Welding.h"

namespace flatten_mesh {

// A triangulated surface, and where it is in the file.
struct Surface_of_model
{
  Mesh mesh;
  Corner_origins origins;
};

// The triangulated surface of the polygons of a model, which are repaired if necessary and requested. Its vertices are
// those of the repaired soup, in the same order; larger polygons are divided into triangles. Throws an `Input_error`
// that names the place unless the polygons form an oriented manifold with finite coordinates.
Surface_of_model build_mesh(const Model& model, Polygon_soup& soup, bool repair, Notes& notes,
                            const Welding& welding = Welding());

} // namespace flatten_mesh

#ifndef FLATTEN_MESH_COMPILED
#include "flatten_mesh/model/build_mesh_impl.h"
#endif

#endif // FLATTEN_MESH_BUILD_MESH_H
