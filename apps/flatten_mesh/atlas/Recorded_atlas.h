// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RECORDED_ATLAS_H
#define FLATTEN_MESH_RECORDED_ATLAS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/atlas/Atlas_record.h"

#include <CGAL/Texture_atlas/Atlas_visitor.h>
#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// An atlas of an input, with all that reports say of it but what files and baking add
struct Recorded_atlas
{
  Atlas atlas; // properties of the mesh of the input
  Atlas_record record;
};

// Makes the atlas that a command describes, of an input that was read. Nothing is written but notes.
Recorded_atlas make_recorded_atlas(const Command_line& command, Atlas_input& input, Notes& notes,
                                   TA::Atlas_visitor& visitor);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RECORDED_ATLAS_H
