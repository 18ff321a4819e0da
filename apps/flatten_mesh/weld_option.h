// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_WELD_OPTION_H
#define FLATTEN_MESH_WELD_OPTION_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/model/Gltf_options.h"
#include "flatten_mesh/model/text_numbers.h"

#include <CGAL/Texture_atlas/internal/prepare/Polygon_soup.h>

#include <optional>
#include <string>

namespace flatten_mesh {

using namespace CGAL::Texture_atlas::internal::prepare;

// The distance that `--weld` gives, if it is a number that can be one
inline std::optional<double> weld_tolerance(const std::string& text)
{
  const std::optional<double> number = finite_number(text);
  return number >= 0 ? number : std::nullopt;
}

// How `--weld` and `--repair` join faces. Without either, an atlas joins all faces that meet; a single chart may be cut
// open where faces do not share vertices.
inline Welding welding_of(const Command_line& command)
{
  if(command.repair != "on" || command.weld == "off") {
    return {Welding::NONE, 0};
  }
  if(command.weld.empty()) {
    return {command.is_plain ? Welding::SEPARATE_FACES : Welding::ALL, 0};
  }
  return {Welding::ALL, weld_tolerance(command.weld).value_or(0)};
}

// How a glTF file is read. What its vertices were split for is joined again even where other faces are not.
inline Gltf_options gltf_options_of(const Command_line& command)
{
  const bool replaces_surface = command.atlas.simplified_triangles > 0 || !command.atlas.bake_from.empty();
  return {command.unique_instances, welding_of(command).extent != Welding::NONE,
          command.output.empty() || (file_format(command.output) == "glb" && !replaces_surface),
          command.atlas.repacks};
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_WELD_OPTION_H
