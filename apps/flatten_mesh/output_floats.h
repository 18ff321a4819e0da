// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_OUTPUT_FLOATS_H
#define FLATTEN_MESH_OUTPUT_FLOATS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/commands_of_inputs.h"
#include "flatten_mesh/file_names.h"

#include <CGAL/Surface_mesh_parameterization/internal/angle_based_flattening/certificate/float_grid.h>

#include <algorithm>
#include <string>
#include <vector>

namespace flatten_mesh {

using CGAL::Surface_mesh_parameterization::internal::ABF::Float_grid;

namespace internal {

template <class Predicate>
bool has_output(const Command_line& command, const Predicate& is_wanted)
{
  const std::vector<Command_line> commands = commands_of_models(command);
  return std::any_of(commands.begin(), commands.end(),
                     [&](const Command_line& each) { return is_wanted(each.output); });
}

} // namespace internal

// Whether an output holds texture coordinates in `float`. All outputs of an atlas then have the same ones.
inline bool writes_floats(const Command_line& command)
{
  return internal::has_output(command, [](const std::string& name) { return !is_obj_output(name); });
}

// The numbers that texture coordinates are rounded to then. Lengths in units of the surface may be so small that 1 - v
// has too few digits for them: only GLB files need it.
inline Float_grid grid_of_outputs(const Command_line& command)
{
  return {(!command.is_plain && !command.atlas.is_in_world_units()) ||
          internal::has_output(command, [](const std::string& name) { return file_format(name) == "glb"; })};
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_OUTPUT_FLOATS_H
