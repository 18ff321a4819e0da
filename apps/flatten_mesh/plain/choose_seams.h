// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHOOSE_SEAMS_H
#define FLATTEN_MESH_CHOOSE_SEAMS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/plain/Run_record.h"
#include "flatten_mesh/plain/Seamed_component.h"

namespace flatten_mesh {

// Whether a component gets seams.
bool is_cut(const Command_line& command, Mesh& mesh, const Component& component);

// Chooses the cones that `--cones` asks for. Throws unless their angles are possible.
Cone_record choose_cones(const Command_line& command, Seamed_component& component);

// Marks the seams along which `--cut` cuts a component.
void choose_seams(const Command_line& command, Mesh& input, Seamed_component& component, Seam_record& record);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHOOSE_SEAMS_H
