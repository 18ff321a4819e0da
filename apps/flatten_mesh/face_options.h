// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_FACE_OPTIONS_H
#define FLATTEN_MESH_FACE_OPTIONS_H

#include "flatten_mesh/Command_line.h"
#include "flatten_mesh/model/Face_choice.h"
#include "flatten_mesh/texts.h"

#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// Names with commas between them
inline std::vector<std::string> separate_names(const std::string& text)
{
  std::vector<std::string> names;
  if(!text.empty()) {
    boost::algorithm::split(names, text, boost::algorithm::is_any_of(","));
  }
  for(std::string& name : names) {
    boost::algorithm::trim(name);
  }
  return names;
}

} // namespace internal

// What `--only-material` and `--ignore` say
inline Face_choice face_choice_of(const Atlas_command& atlas)
{
  return {internal::separate_names(atlas.only_materials), internal::separate_names(atlas.ignored)};
}

namespace internal {

template <class Values>
void check_face_choice(const Values& values, const Atlas_command& atlas)
{
  for(const char* option : {"only-material", "ignore"}) {
    if(values.count(option) == 0) {
      continue;
    }
    const std::vector<std::string> names = separate_names(values[option].template as<std::string>());
    if(names.empty() || contains(names, "")) {
      throw Usage_error(std::string("--") + option + " takes names with commas between them, as in '--" +
                        option + " glass,chrome'");
    }
    if(atlas.simplified_triangles > 0 || !atlas.bake_from.empty()) {
      throw Usage_error(std::string("--") + option +
                        " goes without --simplify and --bake-from: these make a new " +
                        "surface or texture for the whole model");
    }
  }
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_FACE_OPTIONS_H
