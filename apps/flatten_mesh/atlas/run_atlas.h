// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RUN_ATLAS_H
#define FLATTEN_MESH_RUN_ATLAS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Exit_status.h"

namespace flatten_mesh {

// Makes an atlas of the input, and writes what is asked for.
Exit_status run_atlas(const Command_line& command);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RUN_ATLAS_H
