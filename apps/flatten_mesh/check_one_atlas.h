// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_CHECK_ONE_ATLAS_H
#define FLATTEN_MESH_CHECK_ONE_ATLAS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/check_options.h"
#include "flatten_mesh/commands_of_inputs.h"
#include "flatten_mesh/file_names.h"
#include "flatten_mesh/texts.h"

#include <algorithm>
#include <string>
#include <utility>

namespace flatten_mesh {

namespace internal {

// What cannot be done with several models at once. Gives them a title in common.
inline void check_one_atlas(const Values& values, Command_line& command)
{
  if(!command.atlas.is_shared) {
    return;
  }
  for(const auto& [option, reason] : {std::pair("plain", "it makes one chart of one component"),
                                      {"component", "components are numbered within one model"},
                                      {"simplify", "it simplifies one surface"},
                                      {"bake-from", "it bakes one surface"},
                                      {"format", "each model is a file, whose name tells its format"}}) {
    if(is_given(values, option)) {
      throw Usage_error(std::string("--one-atlas goes without --") + option + ": " + reason);
    }
  }
  if(std::count(command.inputs.begin(), command.inputs.end(), standard_input) > 0) {
    throw Usage_error(
        "--one-atlas takes files, and not standard input: outputs have the names of the inputs");
  }
  for(const Output_option& option : output_options()) {
    if(is_of_whole_atlas(command, option) && has_placeholder(command.*option.file)) {
      throw Output_error("--" + option.name + " '" + command.*option.file +
                         "' is written once for all models of --one-atlas: leave the '%' out");
    }
  }
  command.title = count_text(command.inputs.size(), "model");
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_CHECK_ONE_ATLAS_H
