// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_ATLAS_INPUT_H
#define FLATTEN_MESH_ATLAS_INPUT_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Notes.h"
#include "flatten_mesh/model/Corner_origins.h"
#include "flatten_mesh/model/Model.h"
#include "flatten_mesh/model/Polygon_soup.h"
#include "flatten_mesh/model/Skipped_part.h"
#include "flatten_mesh/model/Welding.h"

#include <cstddef>
#include <vector>

namespace flatten_mesh {

// The input of an atlas
struct Atlas_input
{
  Model model;
  Mesh mesh; // without what is set aside; empty if nothing remains
  Corner_origins origins;
  std::vector<Skipped_part> set_aside;
};

// Throws an `Input_error` if the model is wrong as a whole.
Atlas_input atlas_input_of(Model model, bool repair, Notes& notes, const Welding& welding = Welding());

// Throws an `Input_error` if the file cannot be read, or is wrong as a whole.
Atlas_input read_atlas_input(const Command_line& command, Notes& notes);

// The face of the file that a triangle is part of, from 0
inline std::size_t face_in_file(const Atlas_input& input, const Face f)
{
  return input.model.polygon_of_corner(input.origins.corners[input.mesh.halfedge(f).idx()]);
}

} // namespace flatten_mesh

#ifndef FLATTEN_MESH_COMPILED
#include "flatten_mesh/atlas/Atlas_input_impl.h"
#endif

#endif // FLATTEN_MESH_ATLAS_INPUT_H
