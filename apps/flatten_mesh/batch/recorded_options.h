// Copyright (c) 2026 The Angle_based_flattening authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef FLATTEN_MESH_RECORDED_OPTIONS_H
#define FLATTEN_MESH_RECORDED_OPTIONS_H

#include "flatten_mesh/Option_table.h"

#include <boost/algorithm/string/join.hpp>
#include <boost/program_options.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace flatten_mesh {

namespace internal {

// The options that the results of an input depend on, in the order of their names.
inline std::vector<std::string> recorded_options(const boost::program_options::parsed_options& parsed,
                                                 const Option_table& table)
{
  std::vector<std::string> result;
  for(const auto& option : parsed.options) {
    if(table.is_recorded(option.string_key)) {
      result.push_back("--" + option.string_key + (option.value.empty() ? "" : "=") +
                       boost::algorithm::join(option.value, " "));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal

} // namespace flatten_mesh

#endif // FLATTEN_MESH_RECORDED_OPTIONS_H
