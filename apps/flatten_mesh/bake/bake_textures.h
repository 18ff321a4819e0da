// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_BAKE_TEXTURES_H
#define FLATTEN_MESH_BAKE_TEXTURES_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/bake/Baking_record.h"

#include <CGAL/Texture_atlas/Baked_textures.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

using Frame_map = Mesh::Property_map<Halfedge, TA::Tangent_frame>;

struct Baked_surface
{
  TA::Baked_textures textures;
  Frame_map frames; // at the target of each halfedge of a face with a chart
  Baking_record record;
};

// Bakes the surface in the file that the user names. Throws an `Input_error` if it cannot be read or baked. Notes say
// where many rays fail, and what of the model is replaced.
Baked_surface bake_textures(const Command_line& command, Atlas_input& input, const Atlas& atlas,
                            Notes& notes);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_BAKE_TEXTURES_H
