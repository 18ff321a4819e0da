// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FLATTEN_SHEET_H
#define FLATTEN_MESH_FLATTEN_SHEET_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/plain/Chart_record.h"
#include "flatten_mesh/plain/Sheet.h"

#include <cstddef>

namespace flatten_mesh {

// Computes a map of a sheet and measures it. The coordinates are those of the vertices of its mesh.
Flattening flatten_sheet(const Sheet& sheet, const Command_line& command, Progress& progress);

// Rounds the coordinates to those that the output holds, and measures them. The flattening fails if they are no map
// then.
void round_coordinates(const Command_line& command, const Sheet& sheet, Flattening& flattening);

// Makes polygons convex in the plane where small moves of vertices, to places that the output holds, do that. Returns
// how many.
std::size_t mend_polygons(const Command_line& command, const Sheet& sheet, Flattening& flattening);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FLATTEN_SHEET_H
