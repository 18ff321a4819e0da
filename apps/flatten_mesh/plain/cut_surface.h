// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CUT_SURFACE_H
#define FLATTEN_MESH_CUT_SURFACE_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/Progress.h"
#include "flatten_mesh/atlas/Atlas_input.h"
#include "flatten_mesh/plain/Chart_record.h"
#include "flatten_mesh/plain/Sheet.h"

#include <CGAL/Texture_atlas/internal/prepare/Corner_origins.h>

namespace flatten_mesh {

// Whether a component gets seams
bool is_cut(const Command_line& command, Mesh& mesh, const Component& component);

// Chooses the cones that `--cones` asks for. Throws unless their angles are possible.
Cone_record choose_cones(const Command_line& command, Seamed_component& component);

// Marks the seams along which `--cut` cuts a component.
void choose_seams(const Command_line& command, Atlas_input& input, Seamed_component& component,
                  Seam_record& record);

struct Flat_sheet
{
  Sheet sheet;
  Flattening flattening;
};

// Flattens the largest disk that the seams leave. If `--cut auto` chose them, seams are added as long as the scale
// stretch of the map misses the bound.
Flat_sheet flatten_along_seams(const Command_line& command, Mesh& input, Seamed_component& component,
                               Seam_record& record, Progress& progress);

// Splits the chart of a sheet into pieces whose maps are injective, and marks the seams between them.
Split_record split_chart(const Sheet& sheet, const Flattening& flattening, const Atlas& atlas);

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CUT_SURFACE_H
