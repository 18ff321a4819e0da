// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECK_PARTS_H
#define FLATTEN_MESH_CHECK_PARTS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/model/formats.h"
#include "flatten_mesh/texts.h"

#include <string>

namespace flatten_mesh {

namespace internal {

inline void check_part(const bool is_needed, const std::string& option)
{
  if(is_needed) {
    throw Usage_error("this program was built without its part for " + option +
                      ": scripts/flatten adds the part when it is called like this");
  }
}

} // namespace internal

// Throws a `Usage_error` if the command needs a part that the program was built without.
inline void check_parts([[maybe_unused]] const Command_line& command)
{
#ifdef FLATTEN_MESH_WITHOUT_PLAIN
  internal::check_part(command.is_plain, "--plain");
#endif
#ifdef FLATTEN_MESH_WITHOUT_BAKING
  internal::check_part(!command.atlas.bake_from.empty(), "--bake-from");
  internal::check_part(command.atlas.simplified_triangles > 0, "--simplify");
#endif
#ifdef FLATTEN_MESH_WITHOUT_PAGES
  internal::check_part(!command.report.empty() && command.batch.summary.empty(), "--report");
#endif
#ifdef FLATTEN_MESH_WITHOUT_GLB
  internal::check_part(file_format(command.output) == "glb", "--output FILE.glb");
  bool is_read = is_gltf(command.format) || is_gltf(file_format(command.atlas.bake_from));
  for(const std::string& input : command.inputs) {
    is_read = is_read || is_gltf(file_format(input));
  }
  internal::check_part(is_read, ".glb and .gltf files");
#endif
}

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECK_PARTS_H
