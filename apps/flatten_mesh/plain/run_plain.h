// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RUN_PLAIN_H
#define FLATTEN_MESH_RUN_PLAIN_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Exit_status.h"

namespace flatten_mesh {

// Flattens a component of the input as one chart, and writes what is asked for.
Exit_status run_plain(const Command_line& command);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RUN_PLAIN_H
