// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FLATTEN_SHEET_H
#define FLATTEN_MESH_FLATTEN_SHEET_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/plain/Sheet.h"
#include "flatten_mesh/plain/Run_record.h"

namespace flatten_mesh {

void measure(const Sheet& sheet, Flattening& flattening);

// Flattens a sheet by the method that the command names, and measures the map.
Flattening flatten_sheet(const Sheet& sheet, const Command_line& command, Progress& progress);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FLATTEN_SHEET_H
